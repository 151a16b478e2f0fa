// What is left of an elastomer after the temperature shift and without effects of no strength: the
// plain values that every kernel starts from. Pure functions; any thread.
//
// Per length: p = 4 (G y + eta y' + sum G_i e_i), e_i' = y' - e_i / tau_i, with y = -u the depth
// of an element and ' the time derivative; without contact p = 0.
#pragma once

#include <vector>

#include "core/material/elastomer.h"

namespace asperity {

/// Which kernel an element needs: no memory, one relaxation of the free surface, or arms.
enum class ElementKind { Elastic, Kelvin, Arms };

struct ElementLaw {
  double equilibriumModulus = 0;  // Pa, G
  double viscosity = 0;           // Pa s, eta
  double relaxationTime = 0;      // s, eta / G (infinite without G)
  std::vector<Arm> arms;          // strictly falling relaxation times, moduli above 0; arms of less
                                  // than 1e-150 s never remember anything and are left out

  ElementKind kind() const {
    if (!arms.empty()) return ElementKind::Arms;
    return relaxationTime > 0 ? ElementKind::Kelvin : ElementKind::Elastic;
  }
  /// Pa, of all springs together, whatever the dashpot.
  double springModulus() const;
  /// Pa, of a sudden deformation; infinite with a dashpot of its own.
  double glassyModulus() const;

  bool operator==(const ElementLaw&) const = default;
};

/// Returns the arms by falling relaxation time. Arms of equal times are joined into one with the
/// sum of their moduli, which is the same element.
std::vector<Arm> joinedArms(std::vector<Arm> arms);

/// Decades beyond which a shift says nothing any more.
inline constexpr double kMostDecades = 30;

/// What the constants of a shift may be, as scenes have them.
inline constexpr double kMostC1 = 1000, kLeastC2 = 1e-3, kMostC2 = 1e4;  // the latter two K
inline constexpr double kMostActivationEnergy = 1e7;                     // J/mol

/// J/(mol K), the molar gas constant (exact since the SI of 2019).
inline constexpr double kGasConstant = 8.31446261815324;

/// log10 of the factor a_T by which temperature multiplies every relaxation time and the viscosity.
/// Wlf: log10 a_T = -c1 (T - T_r) / (c2 + T - T_r), Williams, Landel and Ferry, J. Am. Chem. Soc.
/// 77, 3701 (1955), valid from the glass transition to about 100 K above it. Arrhenius: ln a_T =
/// E/R (1/T - 1/T_r). Table: linear in T between the rows. The moduli stay as they are, so mu(v, T)
/// = mu(v a_T, T_r). Exactly 0 at the reference temperature. Throws InputError
/// (elastomer.temperature) at or below T_r - c2, where there is no shift, outside of a table, and
/// beyond kMostDecades.
double log10ShiftFactor(const TemperatureShift& shift, double temperature);

/// a_T itself.
double shiftFactor(const TemperatureShift& shift, double temperature);

/// Whether temperature changes any time, or could not.
bool shiftsTimes(const Elastomer& elastomer);

/// The factor of an elastomer at its own temperature; 1 for an elastic one, which has no times.
double temperatureShift(const Elastomer& elastomer);

/// Throws InputError where the elastomer cannot be: nothing in it, a standard solid without its
/// one arm, a temperature without a shift.
ElementLaw elementLaw(const Elastomer& elastomer);

/// The complex modulus at an angular frequency (1/s): storage G' and loss G'' (Pa).
struct ComplexModulus {
  double storage, loss;
};
ComplexModulus complexModulus(const ElementLaw& law, double frequency);

}  // namespace asperity
