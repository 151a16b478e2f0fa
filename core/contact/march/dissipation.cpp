#include "core/contact/march/dissipation.h"

#include <algorithm>
#include <cmath>

#include "core/contact/interface.h"

namespace asperity {

double pressureRounding(std::span<const double> pressure) {
  return pressure.empty() ? 0 : 0.25 * kRounding * std::ranges::max(pressure);
}

std::vector<double> dissipatedPower(const RetardationModes& modes, std::span<const double> pressure,
                                    std::span<const double> amplitudes) {
  std::vector<double> power(pressure.size());
  const double rounding = pressureRounding(pressure);
  for (std::size_t j = 0; j < modes.modes(); ++j) {
    const std::span<const double> amplitude = amplitudes.subspan(j * power.size(), power.size());
    const double stiffness = modes.rate[j] / modes.fluidity[j];
    for (std::size_t i = 0; i < power.size(); ++i) {
      const double unheld = 0.25 * pressure[i] - stiffness * amplitude[i];
      if (std::abs(unheld) > rounding) power[i] += 4 * modes.fluidity[j] * unheld * unheld;
    }
  }
  return power;
}

void addLocalFriction(std::span<double> power, std::span<const double> pressure,
                      const Interface& interface, double velocity) {
  for (std::size_t i = 0; i < power.size(); ++i)
    power[i] += localFrictionLoad(interface, pressure[i]) * std::abs(velocity);
}

}  // namespace asperity
