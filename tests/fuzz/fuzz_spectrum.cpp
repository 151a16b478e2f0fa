// The reader of measured spectra, in each of its conventions: what it takes rises in wave number,
// is finite and has a height.
#include <cmath>

#include "core/surface/spectrum_file.h"
#include "tests/fuzz/fuzz_target.h"

namespace asperity {
namespace {

void requireSound(const SpectralDensity& density) {
  require(density.waveNumber.size() >= 2 && density.density.size() == density.waveNumber.size());
  for (std::size_t i = 0; i < density.waveNumber.size(); ++i) {
    require(std::isfinite(density.waveNumber[i]) && density.waveNumber[i] > 0);
    require(std::isfinite(density.density[i]) && density.density[i] >= 0);
    require(i == 0 || density.waveNumber[i] > density.waveNumber[i - 1]);
  }
}

}  // namespace
}  // namespace asperity

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  for (const SpectrumKind kind :
       {SpectrumKind::C1TwoSided, SpectrumKind::C1OneSided, SpectrumKind::C2})
    readOrRefuse(data, size, [kind](std::string_view text) {
      requireSound(parseSpectrum(text, "spectrum", kind));
    });
  return 0;
}
