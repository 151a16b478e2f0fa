// The law of one element: an elastomer after the temperature shift and without effects of strength
// 0, as the plain values from which every kernel starts. Pure functions; any thread.
//
// Per length, p = 4 (G y + eta y' + sum G_i e_i) with e_i' = y' - e_i / tau_i, where y = -u is the
// depth of an element and ' the time derivative; without contact p = 0.
#pragma once

#include <vector>

#include "core/material/elastomer.h"

namespace asperity {

/// The kernel that an element needs: for no memory, for one relaxation of the free surface, or for
/// arms.
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
  /// Returns the modulus of all springs together, whatever the dashpot; Pa.
  double springModulus() const;
  /// Returns the modulus of a sudden deformation, Pa; infinite with a dashpot of its own.
  double glassyModulus() const;

  bool operator==(const ElementLaw&) const = default;
};

/// Returns the arms by falling relaxation time. Arms of equal times are joined into one with the
/// sum of their moduli, which is the same element.
std::vector<Arm> joinedArms(std::vector<Arm> arms);

/// The largest shift that has a meaning, in decades.
inline constexpr double kMostDecades = 30;

/// Limits of the constants of a shift, as in scenes.
inline constexpr double kMostC1 = 1000, kLeastC2 = 1e-3, kMostC2 = 1e4;  // the latter two K
inline constexpr double kMostActivationEnergy = 1e7;                     // J/mol

/// J/(mol K), the molar gas constant (exact since the SI of 2019).
inline constexpr double kGasConstant = 8.31446261815324;

/// Returns log10 of the factor a_T by which temperature (K) multiplies every relaxation time and
/// the viscosity.
/// Wlf: log10 a_T = -c1 (T - T_r) / (c2 + T - T_r), Williams, Landel and Ferry, J. Am. Chem. Soc.
/// 77, 3701 (1955), valid from the glass transition to about 100 K above it.
/// Arrhenius: ln a_T = E/R (1/T - 1/T_r). Table: linear in T between the rows.
/// The moduli do not change, so mu(v, T) = mu(v a_T, T_r). The result is exactly 0 at the reference
/// temperature. Throws InputError (elastomer.temperature) at or below T_r - c2, where there is no
/// shift, outside of a table, and beyond kMostDecades.
double log10ShiftFactor(const TemperatureShift& shift, double temperature);

/// Returns a_T itself.
double shiftFactor(const TemperatureShift& shift, double temperature);

/// Returns whether the temperature changes the relaxation times, or has no shift at all.
bool shiftsTimes(const Elastomer& elastomer);

/// Returns a_T of an elastomer at its own temperature; 1 for an elastic one, which has no times.
double temperatureShift(const Elastomer& elastomer);

/// Returns the law of the elements of an elastomer. Throws InputError where the elastomer is
/// impossible: it has no modulus, a standard solid has not exactly one arm, or a temperature has no
/// shift.
ElementLaw elementLaw(const Elastomer& elastomer);

/// The complex modulus: storage modulus G' and loss modulus G'' (Pa).
struct ComplexModulus {
  double storage, loss;
};
/// frequency: angular, 1/s.
ComplexModulus complexModulus(const ElementLaw& law, double frequency);

}  // namespace asperity
