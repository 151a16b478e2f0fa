// Study files: what is read has a canonical text, which reads back to the same study.
#include "core/study/study_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/stand_ins.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  return readOrRefuse(data, size, [&](std::string_view text) {
    const ParameterStudy study = readStudy(text, "study.json", "/nowhere", anyScene);
    require(study.simulations() > 0 && !study.outputs.empty());
    const ParameterStudy again = readStudy(study.canonical, "study.json", "/nowhere", anyScene);
    require(again.canonical == study.canonical && again.digest == study.digest);
  });
}
