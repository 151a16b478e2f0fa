// The readers of ready Prony series, and of whatever else a material is made from: what they take
// are finite moduli and relaxation times above 0, the times falling.
#include <cmath>

#include "core/material/prony_file.h"
#include "tests/fuzz/fuzz_target.h"

namespace asperity {
namespace {

std::optional<TextTable> tableIn(std::string_view text) {
  TextTableOptions options;
  options.keepsTexts = true;
  try {
    return readTextTable(text, "series", options);
  } catch (const InputError&) {
    return {};  // keywords are no table
  }
}

void requireSound(const PronyFile& file) {
  require(std::isfinite(file.equilibriumModulus) && file.equilibriumModulus >= 0);
  require(!file.arms.empty());
  for (std::size_t i = 0; i < file.arms.size(); ++i) {
    require(std::isfinite(file.arms[i].modulus) && file.arms[i].modulus > 0);
    require(std::isfinite(file.arms[i].relaxationTime) && file.arms[i].relaxationTime > 0);
    require(i == 0 || file.arms[i].relaxationTime < file.arms[i - 1].relaxationTime);
  }
}

}  // namespace
}  // namespace asperity

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  PronyChoices open, said;
  said.instantaneousModulus = 1e7;
  said.modulusUnit = "Pa";
  said.modulus = ModulusKind::Shear;
  said.isLiquid = true;
  for (const PronyChoices& choices : {open, said})
    readOrRefuse(data, size, [&choices](std::string_view text) {
      const std::optional<TextTable> table = tableIn(text);
      if (const auto file = readPronyFile(text, table ? &*table : nullptr, "series", choices))
        requireSound(*file);
    });
  return 0;
}
