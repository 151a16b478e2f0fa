#include "tests/bench/fields.h"

#include <fmt/format.h>

#include "core/contact/kernels/kernels.h"

namespace asperity::bench {

std::vector<std::string> instructionSets() {
  const InstructionSet best = instructionSet();
  std::vector<std::string> names;
  for (const InstructionSet set :
       {InstructionSet::Scalar, InstructionSet::Avx2, InstructionSet::Avx512})
    if (chooseInstructionSet(set)) names.emplace_back(instructionSetName(set));
  chooseInstructionSet(best);
  return names;
}

std::string gridName(const std::string& path, std::int64_t elements, const std::string& contact) {
  return fmt::format("grid/{}/{}/{}", path, elements, contact);
}

std::string fractionName(double fraction) {
  return fmt::format("fraction/{}", fraction);
}

std::string sameContactName(std::int64_t elements) {
  return fmt::format("same_contact/{}", elements);
}

std::string curveName(const std::string& resolution, std::int64_t realizations) {
  return fmt::format("curve/{}/{}", resolution, realizations);
}

std::string figure4Name(const std::string& path) {
  return fmt::format("figure_4/{}", path);
}

std::string figure2Name(const std::string& path, const std::string& resolution) {
  return fmt::format("figure_2/{}/{}", path, resolution);
}

}  // namespace asperity::bench
