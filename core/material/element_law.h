// The law of one element: an elastomer after its temperature shift (temperature_shift.h) and
// without effects of strength 0, as the plain values from which every kernel starts. Pure
// functions; any thread.
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
