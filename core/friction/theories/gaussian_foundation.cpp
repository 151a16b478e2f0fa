#include "core/friction/theories/gaussian_foundation.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/statistics.h"

namespace asperity {
namespace {

double normalDensity(double x) {
  return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
}

/// Returns Mills's ratio Phi(-x) / phi(x) for x > 0 by its continued fraction (Abramowitz and
/// Stegun 26.2.14), which is exact to rounding for x >= 4 with this many terms.
double millsRatio(double x) {
  double fraction = x;
  for (int k = 60; k >= 1; --k) fraction = x + k / fraction;
  return 1 / fraction;
}

}  // namespace

double gaussianContactFraction(double delta) {
  return std::erfc(-delta / std::numbers::sqrt2) / 2;
}

double gaussianLoad(double delta) {
  // Both terms nearly cancel far above the surface: there phi (1 - x Mills(x)) with
  // 1 - x M = M (fraction - x), which loses nothing.
  constexpr double kFar = -4;
  if (delta > kFar) return normalDensity(delta) + delta * gaussianContactFraction(delta);
  const double x = -delta;
  return normalDensity(x) * millsRatio(x) * (1 / millsRatio(x) - x);
}

double gaussianDepth(double load) {
  // Newton's method on the logarithm of the load, which is a concave function of the depth; from
  // the left of the root it does not overshoot.
  double delta = load > 1 ? load - 1 : -1;
  if (load <= 1)
    while (gaussianLoad(delta) > load) delta *= 2;
  for (int i = 0; i < 200; ++i) {
    const double now = gaussianLoad(delta);
    const double step = now / gaussianContactFraction(delta) * std::log(load / now);
    delta += step;
    if (std::abs(step) <= 1e-15 * (1 + std::abs(delta))) break;
  }
  return delta;
}

double zeroFrequencyViscosity(const ElementLaw& law) {
  double viscosity = law.viscosity;
  for (const Arm& arm : law.arms) viscosity += arm.modulus * arm.relaxationTime;
  return viscosity;
}

GaussianFoundation gaussianFoundation(const ElementLaw& law, double meanSquareHeight,
                                      double meanSquareSlope, double lineForce) {
  if (!(law.equilibriumModulus > 0) || !(meanSquareHeight > 0) || !(lineForce > 0))
    return {kNaN, kNaN, kNaN};
  const double delta =
      gaussianDepth(lineForce / (4 * law.equilibriumModulus * std::sqrt(meanSquareHeight)));
  GaussianFoundation found;
  found.contactFraction = gaussianContactFraction(delta);
  found.slope =
      4 * zeroFrequencyViscosity(law) * found.contactFraction * meanSquareSlope / lineForce;
  constexpr double kBend = 0.05;
  const double plateau = std::sqrt(std::numbers::pi / 2 * meanSquareSlope);
  found.validBelow = found.slope > 0
                         ? plateau * std::sqrt((1 + kBend) * (1 + kBend) - 1) / found.slope
                         : std::numeric_limits<double>::infinity();
  return found;
}

}  // namespace asperity
