#include "core/contact/arms/retardation.h"

#include <cmath>

namespace asperity {
namespace {

/// A rate, stored by its distance from a pole so that no digits are lost next to one: rate = (1 +
/// offset) / tau of the arm `base`, or offset / tau of the slowest arm where base < 0.
struct Rate {
  int base;
  double offset;
};

/// Finds the zeros of f(rate) = G - eta rate + sum G_i rate tau_i / (rate tau_i - 1), which falls
/// from +inf to -inf between neighbouring poles 1 / tau_i.
class Spectrum {
 public:
  explicit Spectrum(const ElementLaw& law) : law_(law) {}

  std::vector<Rate> rates() const {
    std::vector<Rate> found;
    const int arms = static_cast<int>(law_.arms.size());
    if (arms == 0) return found;
    found.push_back(slowest());
    for (int right = 1; right < arms; ++right) found.push_back(between(right - 1, right));
    if (law_.viscosity > 0) found.push_back(halved({arms - 1, 1}, kMin, kMax));
    return found;
  }

  double valueOf(const Rate& rate) const {
    return rate.base < 0 ? rate.offset / tau(0) : (1 + rate.offset) / tau(rate.base);
  }

  /// Returns 1 - rate tau_i.
  double distance(const Rate& rate, std::size_t i) const {
    // Ratios come first: an offset times a time may underflow.
    if (rate.base < 0) return 1 - rate.offset * (tau(i) / tau(0));
    const double base = tau(rate.base);
    return (base - tau(i)) / base - rate.offset * (tau(i) / base);
  }

 private:
  // Logarithms of offsets. Of a mode nearer to its arm's pole than this the depth has no part, and
  // squares of the distance would leave the numbers.
  static constexpr double kMin = -280, kMax = 600;

  template <class Index>
  double tau(Index i) const {
    return law_.arms[static_cast<std::size_t>(i)].relaxationTime;
  }

  double modulusAt(const Rate& rate) const {
    const double value = valueOf(rate);
    double sum = law_.equilibriumModulus - law_.viscosity * value;
    for (std::size_t i = 0; i < law_.arms.size(); ++i)
      sum -= law_.arms[i].modulus * value * tau(i) / distance(rate, i);
    return sum;
  }

  Rate slowest() const {
    if (law_.equilibriumModulus == 0) return {-1, 0};
    const bool fast = modulusAt({-1, 0.5}) > 0;
    return fast ? halved({0, -1}, kMin, std::log(0.5)) : halved({-1, 1}, kMin, std::log(0.5));
  }

  Rate between(int left, int right) const {
    const double step = std::sqrt(tau(left) / tau(right));  // to the geometric mean
    const double fromLeft = step - 1, fromRight = 1 - 1 / step;
    return modulusAt({left, fromLeft}) > 0 ? halved({right, -1}, kMin, std::log(fromRight))
                                           : halved({left, 1}, kMin, std::log(fromLeft));
  }

  /// Bisects the interval of log |offset|; the rate rises with it where the sign is positive.
  Rate halved(Rate sign, double low, double high) const {
    const auto at = [&sign](double t) { return Rate{sign.base, sign.offset * std::exp(t)}; };
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      if (!(middle > low && middle < high)) break;
      const bool before = modulusAt(at(middle)) > 0;  // the zero lies at a higher rate
      (before == (sign.offset > 0) ? low : high) = middle;
    }
    return at(0.5 * (low + high));
  }

  const ElementLaw& law_;
};

void addMode(RetardationModes& modes, const ElementLaw& law, const Spectrum& spectrum,
             const Rate& rate) {
  const double value = spectrum.valueOf(rate);
  double norm = law.viscosity;
  for (std::size_t i = 0; i < law.arms.size(); ++i) {
    const double creep = 1 / spectrum.distance(rate, i);
    norm += law.arms[i].modulus * law.arms[i].relaxationTime * creep * creep;
  }
  modes.rate.push_back(value);
  modes.fluidity.push_back(1 / norm);
  modes.ofDepth.push_back(law.viscosity / norm);
  for (std::size_t i = 0; i < law.arms.size(); ++i) {
    const double distance = spectrum.distance(rate, i), tau = law.arms[i].relaxationTime;
    modes.ofCreep.push_back(law.arms[i].modulus * tau / distance / norm);
    modes.toCreep.push_back(1 / distance);
    modes.toStrain.push_back(-value * tau / distance);
  }
}

}  // namespace

RetardationModes retardationModes(const ElementLaw& law) {
  RetardationModes modes;
  modes.arms = law.arms.size();
  if (law.viscosity == 0) modes.glassyCompliance = 1 / law.glassyModulus();
  if (law.arms.empty() && law.viscosity > 0) {
    modes.rate = {law.equilibriumModulus / law.viscosity};
    modes.fluidity = {1 / law.viscosity};
    modes.ofDepth = {1};
    // A Kelvin element has exactly the rate of the scene.
    if (law.equilibriumModulus > 0) modes.rate = {1 / law.relaxationTime};
    return modes;
  }
  const Spectrum spectrum(law);
  for (const Rate& rate : spectrum.rates()) addMode(modes, law, spectrum, rate);
  return modes;
}

}  // namespace asperity
