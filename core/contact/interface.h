// Local friction in contact, beside what the deformation costs: a constant coefficient or a
// constant tangential load on each length in contact. Changes no deformation; reported apart.
// Amontons and Coulomb; Tabor for the constant shear stress. Costs one operation a result.
#pragma once

#include "core/scene/scene.h"

namespace asperity {

/// Its part of the coefficient of friction, while sliding. contactLength in m; 0 without a force.
inline double localFriction(const Interface& interface, double normalForce, double contactLength) {
  if (!(normalForce > 0)) return 0;
  if (interface.frictionCoefficient > 0) return interface.frictionCoefficient;
  return interface.shearStress * contactLength / normalForce;
}

/// N/m, the tangential load on a place in contact under the line load p (N/m), while sliding; 0
/// where nothing touches.
inline double localFrictionLoad(const Interface& interface, double pressure) {
  if (!(pressure > 0)) return 0;
  if (interface.frictionCoefficient > 0) return interface.frictionCoefficient * pressure;
  return interface.shearStress;
}

}  // namespace asperity
