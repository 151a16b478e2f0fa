#include "app/vector_target.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "core/base/input_error.h"
#include "core/contact/kernels/kernels.h"

namespace asperity {
namespace {

constexpr const char* kVariable = "ASPERITY_TARGET";

/// The targets with the names of the kernels' library, in small letters; the widest comes first.
struct Target {
  std::string_view word;
  InstructionSet set;
};
constexpr std::array<Target, 3> kTargets{{{"avx3", InstructionSet::Avx512},
                                          {"avx2", InstructionSet::Avx2},
                                          {"scalar", InstructionSet::Scalar}}};

std::vector<std::string_view> words() {
  std::vector<std::string_view> words;
  for (const Target& target : kTargets) words.push_back(target.word);
  return words;
}

}  // namespace

void chooseVectorTarget() {
  const char* wanted = std::getenv(kVariable);
  if (wanted == nullptr || *wanted == '\0') return;
  const auto* target = std::ranges::find(kTargets, std::string_view(wanted), &Target::word);
  if (target == kTargets.end()) throw InputError("", kVariable, notOneOf(wanted, words()));
  if (!chooseInstructionSet(target->set))
    throw InputError("", kVariable,
                     message("{} is not what this machine has; {} is", wanted,
                             kTargets[instructionSet() == InstructionSet::Avx2 ? 1 : 2].word));
}

std::string vectorTargetInUse() {
  const auto* target = std::ranges::find(kTargets, instructionSet(), &Target::set);
  return fmt::format("{} kernels", target == kTargets.end() ? "scalar" : target->word);
}

std::string vectorTargetHelp() {
  return fmt::format(
      "Environment: {}={} forces the vectors that are computed with (else the widest of the "
      "machine). They differ in the last digits; with one of them the same scene gives the same "
      "bytes.",
      kVariable, fmt::join(words(), "|"));
}

}  // namespace asperity
