#include "core/scene/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kTurning = 1e-12;  // relative to the amplitude of the velocity: rounding

}  // namespace

bool Motion::jumps() const {
  return sliding_.kind == SlidingKind::Step || sliding_.kind == SlidingKind::Reversal;
}

double Motion::secondVelocity() const {
  return sliding_.kind == SlidingKind::Step ? sliding_.velocityAfter : -sliding_.velocity;
}

double Motion::jump() const {
  return jumps() ? 0.5 * sliding_.duration : sliding_.duration;
}

double Motion::longestStep(std::int64_t leastSteps) const {
  const double step = sliding_.duration / static_cast<double>(leastSteps);
  return isSmooth() ? std::min(step, 1 / (kStepsOfPeriod * sliding_.frequency)) : step;
}

double Motion::stepAt(double time, double spacing, double longest) const {
  const double velocity = fastest(time, time);
  if (!(velocity > 0)) return longest;
  const double node = spacing / velocity;
  return isSmooth() ? std::min(longest, node) : node / std::ceil(node / longest);
}

double Motion::velocityAt(double time) const {
  if (sliding_.kind == SlidingKind::Oscillation) {
    const double velocity =
        sliding_.velocity +
        sliding_.amplitude * std::sin(2 * std::numbers::pi * sliding_.frequency * time);
    // Near the turning point only rounding errors of the time would remain.
    return std::abs(velocity) > kTurning * sliding_.amplitude ? velocity : 0;
  }
  return jumps() && time >= jump() ? secondVelocity() : sliding_.velocity;
}

double Motion::distanceAt(double time) const {
  if (sliding_.kind == SlidingKind::Oscillation) {
    // This is 1 - cos without cancellation.
    const double half = std::sin(std::numbers::pi * sliding_.frequency * time);
    return sliding_.velocity * time +
           sliding_.amplitude * half * half / (std::numbers::pi * sliding_.frequency);
  }
  if (!jumps() || time <= jump()) return sliding_.velocity * time;
  return sliding_.velocity * jump() + secondVelocity() * (time - jump());
}

double Motion::fastest(double from, double to) const {
  if (sliding_.kind == SlidingKind::Oscillation) return sliding_.velocity + sliding_.amplitude;
  // An interval that ends at the jump has the velocity before it.
  const double first = std::abs(velocityAt(from));
  return jumps() && to > jump() ? std::max(first, std::abs(secondVelocity())) : first;
}

}  // namespace asperity
