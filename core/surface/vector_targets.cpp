// Which instruction sets Highway may choose from. These three functions replace those of libhwy,
// because every program that loads libhwy measures its timer for three milliseconds first.
#include <hwy/targets.h>

#include <cstdint>

namespace hwy {
namespace {

std::int64_t restricted = 0;  // what is used instead of what the machine has; 0 without it

std::int64_t targetsOfMachine() {
  std::int64_t targets = HWY_STATIC_TARGET | HWY_SCALAR;
#if HWY_ARCH_X86
  // The levels of x86-64 have exactly what Highway's code for AVX2 and AVX-512 needs.
  if (__builtin_cpu_supports("x86-64-v3")) targets |= HWY_AVX2;
  if (__builtin_cpu_supports("x86-64-v4")) targets |= HWY_AVX3;
#endif
  return targets;
}

}  // namespace

std::int64_t SupportedTargets() {
  static const std::int64_t machine = targetsOfMachine();
  return restricted != 0 ? restricted : machine;
}

void SetSupportedTargetsForTest(std::int64_t targets) {
  restricted = targets;
}

ChosenTarget& GetChosenTarget() {
  static ChosenTarget chosen;
  return chosen;
}

}  // namespace hwy
