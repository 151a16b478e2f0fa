#include "app/vector_target.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <string_view>

#include "core/base/named_choices.h"
#include "core/contact/kernels/kernels.h"

namespace asperity {
namespace {

constexpr const char* kVariable = "ASPERITY_TARGET";

/// The targets with the names of the kernels' library, in small letters; the widest comes first.
constexpr NamedChoices<InstructionSet, 3> kTargets{{{"avx3", InstructionSet::Avx512},
                                                    {"avx2", InstructionSet::Avx2},
                                                    {"scalar", InstructionSet::Scalar}}};

std::string_view wordInUse() {
  return choiceWord(kTargets, instructionSet());
}

}  // namespace

void chooseVectorTarget() {
  const char* wanted = std::getenv(kVariable);
  if (wanted == nullptr || *wanted == '\0') return;
  if (!chooseInstructionSet(chosen(kTargets, wanted, kVariable)))
    throw InputError("", kVariable,
                     message("{} is not what this machine has; {} is", wanted, wordInUse()));
}

std::string vectorTargetInUse() {
  return fmt::format("{} kernels", wordInUse());
}

std::string vectorTargetHelp() {
  return fmt::format(
      "Environment: {}={} forces the vectors that are computed with (else the widest of the "
      "machine). They differ in the last digits; with one of them the same scene gives the same "
      "bytes.",
      kVariable, fmt::join(choiceWords(kTargets), "|"));
}

}  // namespace asperity
