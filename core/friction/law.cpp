#include "core/friction/law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

/// beta at H = 0, 0.1, ... 1, each with a standard error of 0.003 to 0.006, from the results of
/// `asperity figure 5 --realizations 4000 --set accuracy.oversampling=4`.
constexpr std::array<double, 11> kBeta{2.724, 2.187, 1.929, 1.806, 1.747, 1.715,
                                       1.691, 1.657, 1.593, 1.471, 1.274};

double squared(double value) {
  return value * value;
}

}  // namespace

double lowVelocityFriction(const LawInput& in, double alpha, double beta) {
  return beta * in.relaxationTime * in.velocity * squared(in.rmsSlope) / in.rmsHeight *
         std::pow(1 / dimensionlessForce(in), alpha);
}

double contactFriction(const LawInput& in, double contactLength, double rmsSlopeContact) {
  const double viscosity = in.shearModulus * in.relaxationTime;
  return 4 * contactLength * viscosity * squared(rmsSlopeContact) / in.normalForce * in.velocity;
}

double forceExponent(double hurst) {
  return hurst / (1 + hurst);
}

double fullContactFriction(const LawInput& in) {
  return contactFriction(in, in.length, in.rmsSlope);
}

double plateauFriction(double rmsSlopeContact) {
  return std::numbers::sqrt2 * rmsSlopeContact;
}

double frictionLaw(const LawInput& in, double beta) {
  if (in.velocity == 0 || in.relaxationTime == 0) return 0;
  const double slow = lowVelocityFriction(in, forceExponent(in.hurst), beta);
  return 1 / std::hypot(1 / plateauFriction(in.rmsSlope), 1 / fullContactFriction(in), 1 / slow);
}

double frictionLaw(const LawInput& in) {
  return frictionLaw(in, lawPrefactor(in.hurst));
}

double dimensionlessVelocity(const LawInput& in) {
  return in.relaxationTime * in.velocity * in.rmsSlope / (std::numbers::sqrt2 * in.rmsHeight);
}

double dimensionlessForce(const LawInput& in) {
  return in.normalForce / (in.shearModulus * in.rmsHeight * in.length);
}

double lawPrefactor(double hurst) {
  const double position = std::clamp(hurst, 0.0, 1.0) * (kBeta.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(position), kBeta.size() - 2);
  const double part = position - static_cast<double>(below);
  return kBeta[below] + part * (kBeta[below + 1] - kBeta[below]);
}

}  // namespace asperity
