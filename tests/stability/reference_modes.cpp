#include "tests/stability/reference_modes.h"

#include <cmath>
#include <optional>

namespace asperity {
namespace {

constexpr Wide kMin = -5000, kMax = 5000;  // logarithms of numbers whose squares are numbers

/// A rate (1/s) beside that of an arm: (1 + sign exp(log)) / tau, or exp(log) / tau of the slowest
/// arm where it is beside 0. No digits are lost next to an arm's.
struct Place {
  const ElementLaw& law;
  std::optional<std::size_t> arm;
  int sign;
  Wide log;

  Wide tau(std::size_t i) const { return law.arms[i].relaxationTime; }
  Wide rate() const {
    return arm ? (1 + sign * std::exp(log)) / tau(*arm) : std::exp(log) / tau(0);
  }
  /// 1 - rate tau_i.
  Wide apart(std::size_t i) const {
    if (!arm) return 1 - std::exp(log) * (tau(i) / tau(0));
    return (tau(*arm) - tau(i)) / tau(*arm) - sign * std::exp(log) * (tau(i) / tau(*arm));
  }
  /// What is left of the force of an element whose depth decays at this rate, per depth (Pa).
  Wide force() const {
    Wide sum = law.equilibriumModulus - law.viscosity * rate();
    for (std::size_t i = 0; i < law.arms.size(); ++i)
      sum -= law.arms[i].modulus * rate() * tau(i) / apart(i);
    return sum;
  }
};

/// The place between low and high where no force is left; it falls with the rate.
Place free(Place place, Wide low, Wide high) {
  const bool risesWithLog = !place.arm || place.sign > 0;
  place.log = bisect(low, high, [&](Wide log) {
    Place here{place.law, place.arm, place.sign, log};
    return risesWithLog ? -here.force() : here.force();
  });
  return place;
}

std::vector<Place> places(const ElementLaw& law) {
  std::vector<Place> found;
  const auto half = std::log(Wide(0.5));
  const Place belowFirst{law, std::nullopt, 1, half};
  found.push_back(belowFirst.force() < 0 ? free(belowFirst, kMin, half)
                                         : free({law, 0, -1, 0}, kMin, half));
  for (std::size_t right = 1; right < law.arms.size(); ++right) {
    const Wide ratio =
        std::sqrt(Wide(law.arms[right - 1].relaxationTime) / law.arms[right].relaxationTime);
    const Place middle{law, right - 1, 1, std::log(ratio - 1)};
    found.push_back(middle.force() < 0 ? free(middle, kMin, middle.log)
                                       : free({law, right, -1, 0}, kMin, std::log(1 - 1 / ratio)));
  }
  if (law.viscosity > 0) found.push_back(free({law, law.arms.size() - 1, 1, 0}, kMin, kMax));
  return found;
}

}  // namespace

std::vector<ReferenceMode> referenceModes(const ElementLaw& law, Wide velocity) {
  std::vector<ReferenceMode> modes;
  for (const Place& place : places(law)) {
    Wide norm = law.viscosity;
    for (std::size_t i = 0; i < law.arms.size(); ++i)
      norm += law.arms[i].modulus * place.tau(i) / (place.apart(i) * place.apart(i));
    ReferenceMode mode{
        place.rate() / velocity, law.equilibriumModulus / (place.rate() * norm), {}, {}, {}};
    for (std::size_t i = 0; i < law.arms.size(); ++i) {
      mode.ofCreep.push_back(law.arms[i].modulus * place.tau(i) / place.apart(i) / norm);
      mode.toCreep.push_back(1 / place.apart(i));
      mode.toStrain.push_back(-place.rate() * place.tau(i) / place.apart(i));
    }
    modes.push_back(mode);
  }
  return modes;
}

}  // namespace asperity
