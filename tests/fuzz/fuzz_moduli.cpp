// The reader of tables of dynamic moduli and the gathering of isotherms: what they take are finite
// moduli above 0 at rising temperatures and frequencies. A file may leave units and temperature
// open; here they are chosen, so that this is no reason to stop.
#include <cmath>

#include "core/material/dma_file.h"
#include "tests/fuzz/fuzz_target.h"

namespace asperity {
namespace {

bool isAboveZero(double value) {
  return std::isfinite(value) && value > 0;
}

void requireSound(const std::vector<Isotherm>& isotherms) {
  require(!isotherms.empty());
  for (std::size_t i = 0; i < isotherms.size(); ++i) {
    require(isAboveZero(isotherms[i].temperature));
    require(i == 0 || isotherms[i].temperature > isotherms[i - 1].temperature);
    const std::vector<DynamicModulus>& points = isotherms[i].points;
    require(points.size() >= 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
      require(isAboveZero(points[k].frequency) && isAboveZero(points[k].storage) &&
              isAboveZero(points[k].loss));
      require(k == 0 || points[k].frequency > points[k - 1].frequency);
    }
  }
}

}  // namespace
}  // namespace asperity

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  DmaChoices open, said;
  said.frequencyUnit = "Hz";
  said.modulusUnit = "MPa";
  said.modulus = ModulusKind::Shear;
  said.temperature = 293.15;
  for (const DmaChoices& choices : {open, said})
    readOrRefuse(data, size, [&choices](std::string_view text) {
      TextTableOptions options;
      options.keepsTexts = true;
      const DmaFile file = readDmaFile(readTextTable(text, "moduli", options), "moduli", choices);
      requireSound(groupIsotherms(file.rows));
    });
  return 0;
}
