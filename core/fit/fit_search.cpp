#include "core/fit/fit_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/input_error.h"

namespace asperity {
namespace {

using Eigen::VectorXd;

/// Returns the coordinates from which the fit begins. Where friction is far from the measured
/// values, a fit of logarithms comes first.
VectorXd startNearPoints(const Objective& objective, const VectorXd& start) {
  const double distance = objective.logarithmicDistance(objective.evaluate(start, {}));
  if (distance < kFarFromPoints || !std::isfinite(distance)) return start;
  return minimize(objective, start, objective.all(), kFitIterations, Distance::Logarithm)
      .coordinates;
}

/// Returns whether a minimum leaves so much that another one may be the right one: chi squared
/// far above the degrees of freedom, or without errors points that scatter by more than a tenth.
bool isFarOff(const Objective& objective, const Minimum& found) {
  constexpr double kFarAbove = 10, kScatter = 0.1;
  const double perFreedom = found.chiSquared / static_cast<double>(objective.degreesOfFreedom());
  return perFreedom > (objective.hasErrors() ? kFarAbove : kScatter * kScatter);
}

/// Returns the coordinates that a slider reaches, within the parameter's limits.
std::pair<double, double> sliderCoordinates(const VariedParameter& parameter) {
  const SliderRange slider = *sliderRange(parameter.row());
  // A logarithmic slider may begin at none, which has no coordinate.
  constexpr double kDecades = 1e-6;
  const double first =
      parameter.isLogarithmic() ? std::max(slider.from, kDecades * slider.to) : slider.from;
  const auto within = [&](double value) {
    return std::clamp(parameter.coordinate(value), parameter.lowest(), parameter.highest());
  };
  return {within(first), within(slider.to)};
}

/// Returns the best of some values of one parameter over the range of its slider, the others held.
Minimum bestAlong(const Objective& objective, int k, const VectorXd& around) {
  constexpr int kValues = 11;
  const VariedParameter& parameter = objective.parameter(k);
  const auto [from, to] = sliderCoordinates(parameter);
  Minimum best{around, std::numeric_limits<double>::infinity(), false};
  for (int i = 0; i < kValues; ++i) try {
      VectorXd coordinates = around;
      coordinates[k] = from + (to - from) * i / (kValues - 1);
      const double chiSquared = atCoordinates(objective, coordinates).chiSquared;
      if (chiSquared < best.chiSquared) best = {std::move(coordinates), chiSquared, false};
    } catch (const InputError&) {
      continue;  // a state that cannot slide
    }
  return best;
}

/// Searches again from other coordinates. A parameter may have left the range in which friction
/// answers to it, from where no slope leads back: so each one in turn is set to values over
/// its slider's whole range, the others as found, and the search goes on from the best of them,
/// as long as that helps.
Minimum fromOtherStarts(const Objective& objective, Minimum best) {
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds && isFarOff(objective, best); ++round) {
    const double before = best.chiSquared;
    const VectorXd around = best.coordinates;
    for (const int k : objective.all()) {
      const Minimum start = bestAlong(objective, k, around);
      if (!std::isfinite(start.chiSquared)) continue;
      try {
        Minimum found = minimize(objective, start.coordinates, objective.all(), kFitIterations);
        if (found.chiSquared < best.chiSquared) best = std::move(found);
      } catch (const InputError&) {
        // A start from which no state can slide leads nowhere.
      }
    }
    if (!(best.chiSquared < 0.99 * before)) break;
  }
  return best;
}

}  // namespace

Minimum findMinimum(const Objective& objective, const VectorXd& start) {
  const Minimum best =
      minimize(objective, startNearPoints(objective, start), objective.all(), kFitIterations);
  return isFarOff(objective, best) ? fromOtherStarts(objective, best) : best;
}

}  // namespace asperity
