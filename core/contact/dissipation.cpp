#include "core/contact/dissipation.h"

namespace asperity {

std::vector<double> dissipatedPower(const RetardationModes& modes, std::span<const double> pressure,
                                    std::span<const double> amplitudes) {
  std::vector<double> power(pressure.size());
  for (std::size_t j = 0; j < modes.modes(); ++j) {
    const std::span<const double> amplitude = amplitudes.subspan(j * power.size(), power.size());
    for (std::size_t i = 0; i < power.size(); ++i) {
      const double creep = 0.25 * modes.fluidity[j] * pressure[i] - modes.rate[j] * amplitude[i];
      power[i] += 4 * creep * creep / modes.fluidity[j];
    }
  }
  return power;
}

}  // namespace asperity
