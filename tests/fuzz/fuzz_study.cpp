// Study files: what is read has a canonical text, which reads back to the same study.
#include <vector>

#include "core/friction/curve_file.h"
#include "core/scene/scene_file.h"
#include "core/study/study_file.h"
#include "tests/fuzz/fuzz_target.h"

namespace asperity {

// The columns of a friction curve, without what computes it.
std::vector<std::string_view> curveColumns() {
  return {"velocity", "mu", "contact_fraction", "indentation"};
}

}  // namespace asperity

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  // No file is read but the study itself.
  const auto anyScene = [](const std::string&, const std::filesystem::path& folder,
                           const std::vector<std::string>& assignments) {
    return readScene("{}", "scene", folder, assignments);
  };
  return readOrRefuse(data, size, [&](std::string_view text) {
    const ParameterStudy study = readStudy(text, "study.json", "/nowhere", anyScene);
    require(study.simulations() > 0 && !study.outputs.empty());
    const ParameterStudy again = readStudy(study.canonical, "study.json", "/nowhere", anyScene);
    require(again.canonical == study.canonical && again.digest == study.digest);
  });
}
