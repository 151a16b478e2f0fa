#include "core/contact/kernels/lane_pass.h"

// One lane runs everywhere; AVX2 and AVX-512 are the steps worth a kernel of their own.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/contact/kernels/lane_pass.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/base/flush_denormals.h"
#include "core/contact/kernels/nodal_lane_pass-inl.h"

HWY_BEFORE_NAMESPACE();
namespace asperity {
namespace HWY_NAMESPACE {

void passNodal(const PreparedProfile& line, const double* depth, const double* memory,
               NodalLaneSums& sums) {
  NodalLanePass<false>(line, depth, memory).run(sums);
}
void passNodalAll(const PreparedProfile& line, const double* depth, const double* memory,
                  NodalLaneSums& sums) {
  NodalLanePass<true>(line, depth, memory).run(sums);
}
std::size_t lanes() {
  return hn::Lanes(hn::CappedTag<double, kMostLanes>());
}

}  // namespace HWY_NAMESPACE
}  // namespace asperity
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asperity {

HWY_EXPORT(passNodal);
HWY_EXPORT(passNodalAll);
HWY_EXPORT(lanes);

namespace {

/// The tables of functions are indexed by the chosen target, which is found at the first call.
void useTargets(std::int64_t mask) {
  hwy::SetSupportedTargetsForTest(mask);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

std::int64_t targetOf(InstructionSet set) {
  switch (set) {
    case InstructionSet::Scalar:
      return HWY_SCALAR;
    case InstructionSet::Avx2:
      return HWY_AVX2;
    case InstructionSet::Avx512:
      return HWY_AVX3;
    case InstructionSet::Best:
      break;
  }
  return 0;  // no restriction
}

}  // namespace

bool chooseInstructionSet(InstructionSet wanted) {
  useTargets(0);
  const std::int64_t target = targetOf(wanted);
  if (target != 0 && (hwy::SupportedTargets() & target) == 0) return false;
  useTargets(target);
  return true;
}

InstructionSet instructionSet() {
  const std::int64_t usable = hwy::SupportedTargets() & HWY_TARGETS;
  if (usable & HWY_AVX3) return InstructionSet::Avx512;
  if (usable & HWY_AVX2) return InstructionSet::Avx2;
  return InstructionSet::Scalar;
}

const char* nameOf(InstructionSet set) {
  switch (set) {
    case InstructionSet::Scalar:
      return "scalar";
    case InstructionSet::Avx2:
      return "AVX2";
    case InstructionSet::Avx512:
      return "AVX-512";
    case InstructionSet::Best:
      break;
  }
  return "best";
}

std::size_t laneCount() {
  return HWY_DYNAMIC_DISPATCH(lanes)();
}

void nodalLanePass(const PreparedProfile& line, const LaneValues& depth, const LaneValues& memory,
                   Wanted wanted, NodalLaneSums& sums) {
  const FlushDenormals flush(Traps::None);
  alignas(64) LaneValues d = depth, c = memory;
  if (wanted == Wanted::Force)
    HWY_DYNAMIC_DISPATCH(passNodal)(line, d.data(), c.data(), sums);
  else
    HWY_DYNAMIC_DISPATCH(passNodalAll)(line, d.data(), c.data(), sums);
}

}  // namespace asperity
#endif  // HWY_ONCE
