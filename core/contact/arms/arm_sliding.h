// Steady sliding of elements with arms at one velocity after the other, in SI units.
// Threading: functions of their arguments; line, law and modes are shared freely.
// Failure: no exception; the result's status says whether balance and period closed.
#pragma once

#include "core/contact/arms/arm_balance.h"
#include "core/contact/steady_sliding.h"

namespace asperity {

/// A balance that began somewhere, to start the next one from.
struct ArmState {
  SteadyResult result;
  ArmBalance balance;
};

/// law: with an equilibrium modulus and at least one arm; velocity > 0 (m/s). `guess` may be null.
/// Where a search from the guess and one from nothing both fail, the answer is followed up from a
/// velocity so low that the arms forget.
ArmState slideWithArms(const PreparedProfile& line, const ElementLaw& law,
                       const RetardationModes& modes, const Load& load, double velocity,
                       const ArmState* guess = nullptr);

/// Shape and memory at that state; pressure per 4G.
ArmShape armShapeAt(const PreparedProfile& line, const ElementLaw& law,
                    const RetardationModes& modes, double velocity, const ArmBalance& balance);

}  // namespace asperity
