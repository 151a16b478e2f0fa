#include "core/material/element_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/material/temperature_shift.h"

namespace asperity {
namespace {

constexpr double kSmallestModulus = 1e-6;  // Pa, that is not 0

/// In a shorter time the line slides less than 1e-130 of an element at any velocity, and the load
/// of such an arm or dashpot is below 1e-80 of the whole. Ratios and squares of longer times are
/// within the range of a double.
constexpr double kShortestTime = 1e-150;  // s

/// Returns the arms that matter: those without a modulus bear nothing, those with (nearly) no
/// relaxation time remember nothing.
std::vector<Arm> withStrength(const std::vector<Arm>& given, double shift) {
  std::vector<Arm> arms;
  for (const Arm& arm : given)
    if (arm.modulus > 0 && arm.relaxationTime * shift >= kShortestTime)
      arms.push_back({arm.modulus, arm.relaxationTime * shift});
  return joinedArms(std::move(arms));
}

void checkModulus(double modulus, const std::string& key) {
  if (modulus != 0 && modulus < kSmallestModulus)
    throw InputError(
        "", key,
        message("{} Pa is neither 0 nor at least {} Pa", plain(modulus), plain(kSmallestModulus)));
}

void checkArms(const Elastomer& elastomer) {
  if (elastomer.rheology == Rheology::StandardSolid && elastomer.arms.size() != 1)
    throw InputError("", "elastomer.arms",
                     message("a standard solid has one arm, not {}", elastomer.arms.size()));
  for (std::size_t i = 0; i < elastomer.arms.size(); ++i)
    checkModulus(elastomer.arms[i].modulus, fmt::format("elastomer.arms[{}].modulus", i));
  checkModulus(elastomer.equilibriumModulus, "elastomer.equilibrium_modulus");
}

}  // namespace

std::vector<Arm> joinedArms(std::vector<Arm> arms) {
  std::ranges::stable_sort(arms, std::greater<>(), &Arm::relaxationTime);
  std::vector<Arm> joined;
  for (const Arm& arm : arms) {
    if (!joined.empty() && joined.back().relaxationTime == arm.relaxationTime)
      joined.back().modulus += arm.modulus;
    else
      joined.push_back(arm);
  }
  return joined;
}

double ElementLaw::springModulus() const {
  double modulus = equilibriumModulus;
  for (const Arm& arm : arms) modulus += arm.modulus;
  return modulus;
}

double ElementLaw::glassyModulus() const {
  return viscosity > 0 ? std::numeric_limits<double>::infinity() : springModulus();
}

ElementLaw elementLaw(const Elastomer& elastomer) {
  ElementLaw law;
  if (elastomer.rheology == Rheology::Elastic) {
    law.equilibriumModulus = elastomer.shearModulus;
    return law;
  }
  const double shift = shiftFactor(elastomer.shift, elastomer.temperature);
  if (elastomer.rheology == Rheology::Kelvin) {
    law.equilibriumModulus = elastomer.shearModulus;
    law.relaxationTime = elastomer.relaxationTime * shift;
    law.viscosity = law.equilibriumModulus * law.relaxationTime;
    return law;
  }
  checkArms(elastomer);
  law.equilibriumModulus = elastomer.equilibriumModulus;
  law.arms = withStrength(elastomer.arms, shift);
  if (elastomer.rheology == Rheology::Prony) law.viscosity = elastomer.viscosity * shift;
  // Beside arms, a dashpot whose creep under their springs takes no time bears nothing.
  if (!law.arms.empty() && law.viscosity < kShortestTime * law.springModulus()) law.viscosity = 0;
  if (law.viscosity > 0)
    law.relaxationTime = law.equilibriumModulus > 0 ? law.viscosity / law.equilibriumModulus
                                                    : std::numeric_limits<double>::infinity();
  if (law.equilibriumModulus == 0 && law.arms.empty() && law.viscosity == 0)
    throw InputError("", "elastomer.equilibrium_modulus",
                     "is 0, and there are neither arms nor a dashpot: the elastomer would "
                     "have no force");
  return law;
}

ComplexModulus complexModulus(const ElementLaw& law, double frequency) {
  ComplexModulus modulus{law.equilibriumModulus, law.viscosity * frequency};
  for (const Arm& arm : law.arms) {
    const double turn = frequency * arm.relaxationTime, part = arm.modulus / (1 + turn * turn);
    modulus.storage += part * turn * turn;
    modulus.loss += part * turn;
  }
  return modulus;
}

}  // namespace asperity
