#include "core/friction/figures/readings.h"

#include <algorithm>
#include <cmath>

#include "core/friction/fit.h"

namespace asperity {
namespace {

/// Where values pass `level` between two velocities, straight in logarithms; NaN: never.
template <class Value>
double crossing(const std::vector<double>& velocities, std::size_t from, double level,
                const Value& value) {
  for (std::size_t i = from; i + 1 < velocities.size(); ++i) {
    const double a = std::log(value(i) / level), b = std::log(value(i + 1) / level);
    if (a == 0) return velocities[i];
    if ((a < 0) != (b < 0))
      return velocities[i] * std::pow(velocities[i + 1] / velocities[i], a / (a - b));
  }
  return kNotApplicable;
}

std::size_t highest(const Study& study, std::size_t j, int leftOut) {
  std::size_t top = 0;
  for (std::size_t i = 1; i < study.velocities().size(); ++i)
    if (study.mu(j, i, leftOut) > study.mu(j, top, leftOut)) top = i;
  return top;
}

}  // namespace

double velocityExponent(const Study& study, std::size_t j, std::size_t first, std::size_t last,
                        int leftOut) {
  std::vector<double> velocities, mu;
  for (std::size_t i = first; i <= last; ++i) {
    velocities.push_back(study.velocities()[i]);
    mu.push_back(study.mu(j, i, leftOut));
  }
  return fitPower(velocities, mu).slope;
}

Plateau plateauOf(const Study& study, std::size_t j, int leftOut) {
  const std::vector<double>& velocities = study.velocities();
  const std::size_t top = highest(study, j, leftOut);
  const double middle = study.normalizedMu(j, top, leftOut);
  if (top == 0 || top + 1 == velocities.size()) return {velocities[top], middle};
  // Velocities are evenly spaced in their logarithm.
  const double before = study.normalizedMu(j, top - 1, leftOut);
  const double after = study.normalizedMu(j, top + 1, leftOut);
  const double bend = before - 2 * middle + after;
  const double shift = bend < 0 ? 0.5 * (before - after) / bend : 0;
  return {velocities[top] * std::pow(velocities[top + 1] / velocities[top], shift),
          middle - 0.25 * (before - after) * shift};
}

RegionBorders regionBorders(const Study& study, std::size_t j, int leftOut) {
  const std::vector<double>& velocities = study.velocities();
  const double perVelocity = study.mu(j, 0, leftOut) / velocities[0];
  const double reached = kOfPlateau * plateauOf(study, j, leftOut).normalizedMu;
  const auto overLine = [&](std::size_t i) {
    return study.mu(j, i, leftOut) / (perVelocity * velocities[i]);
  };
  const auto normalized = [&](std::size_t i) { return study.normalizedMu(j, i, leftOut); };
  return {crossing(velocities, 0, kBelowLine, overLine),
          crossing(velocities, 0, reached, normalized),
          crossing(velocities, highest(study, j, leftOut), reached, normalized)};
}

double normalizedMuAt(const Study& study, std::size_t j, double velocity, int leftOut) {
  const std::vector<double>& velocities = study.velocities();
  const auto above = std::upper_bound(velocities.begin() + 1, velocities.end() - 1, velocity);
  const auto i = static_cast<std::size_t>(above - velocities.begin());
  const double part =
      std::log(velocity / velocities[i - 1]) / std::log(velocities[i] / velocities[i - 1]);
  const double before = study.normalizedMu(j, i - 1, leftOut);
  return before * std::pow(study.normalizedMu(j, i, leftOut) / before, part);
}

double lowVelocityFactor(const Study& study, std::size_t j, std::size_t i, int leftOut) {
  const LawInput in = study.lawInput(j, i);
  return study.mu(j, i, leftOut) * in.rmsHeight /
         (in.relaxationTime * in.velocity * in.rmsSlope * in.rmsSlope);
}

}  // namespace asperity
