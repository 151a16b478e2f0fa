#include "core/contact/arms/arm_guess.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/contact/line/polynomial.h"

namespace asperity {

ArmGuess::ArmGuess(const ElementLaw& law) : law_(law) {
  for (const Arm& arm : law.arms) logTime_.push_back(std::log(arm.relaxationTime));
}

void ArmGuess::take(double velocity, const ArmBalance& balance) {
  std::swap(before_, last_);
  if (!balance.isMet()) {
    last_.velocity = before_.velocity = 0;
    return;
  }
  last_.velocity = velocity;
  last_.depth = balance.force.depth;
  last_.strain.assign(balance.strain.begin(), balance.strain.end());
}

/// Returns the strain of an arm of any relaxation length (m) at a known velocity: by the cubic in
/// its logarithm through the neighbouring arms. For arms slower than all others it is a + b / c,
/// for faster ones proportional to c.
double ArmGuess::strainAt(const Known& known, double relaxationLength) const {
  const std::vector<Arm>& arms = law_.arms;
  const std::vector<double>& strain = known.strain;
  const std::size_t count = arms.size();
  const double tau = relaxationLength / known.velocity;
  // Arms before `next` are slower.
  std::size_t next = 0;
  while (next < count && arms[next].relaxationTime > tau) ++next;
  if (next == count) return strain.back() * (tau / arms.back().relaxationTime);
  if (arms[next].relaxationTime == tau || count == 1) return strain[next];
  if (next == 0) {
    const double slowest = arms[0].relaxationTime;
    return strain[0] +
           (strain[0] - strain[1]) * (1 - slowest / tau) / (slowest / arms[1].relaxationTime - 1);
  }
  const std::size_t window = std::min<std::size_t>(count, 4);
  const std::size_t first = std::min(next > 1 ? next - 2 : 0, count - window);
  return lagrangePolynomial(std::span(logTime_).subspan(first, window),
                            std::span(strain).subspan(first, window), std::log(tau));
}

const ArmBalance* ArmGuess::at(double velocity) {
  constexpr double kMaxExtrapolation = 1.5;  // of the step before, to go on as it went
  if (last_.velocity == 0) return nullptr;
  double ahead = 0;
  if (before_.velocity > 0 && before_.velocity != last_.velocity)
    ahead = std::log(velocity / last_.velocity) / std::log(last_.velocity / before_.velocity);
  if (!(ahead > 0 && ahead < kMaxExtrapolation)) ahead = 0;
  guess_.force.depth = last_.depth;
  if (ahead > 0) guess_.force.depth *= std::pow(last_.depth / before_.depth, ahead);
  guess_.strain.resize(last_.strain.size());
  for (std::size_t i = 0; i < guess_.strain.size(); ++i) {
    const double c = velocity * law_.arms[i].relaxationTime;
    double& strain = guess_.strain[i];
    strain = strainAt(last_, c);
    if (ahead > 0) strain += ahead * (strain - strainAt(before_, c));
  }
  return &guess_;
}

}  // namespace asperity
