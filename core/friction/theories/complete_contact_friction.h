// Friction where the whole line is in contact, for any linear rheology: the surface of the
// elastomer is the line itself, each wave of it is a harmonic deformation at the angular frequency
// q v, and the losses of all waves add up:
//   mu F_N = 2 L integral_0^inf q C1(q) 4 G''(q v) dq.
// The pressure is p = F_N / L + 4 sum |G*(q v)| times the waves; contact is complete where it is
// above 0 everywhere. Pure; any thread.
#pragma once

#include "core/friction/theories/line_spectrum.h"
#include "core/material/element_law.h"

namespace asperity {

struct CompleteContactFriction {
  double mu = 0;
  double rmsPressure = 0;  // N/m, of the pressure's variation about its mean F_N / L
};

/// Returns the friction at a velocity (m/s). lineForce: F_N / L in N/m, above 0.
CompleteContactFriction completeContactFriction(const ElementLaw& law, const WaveSpectrum& spectrum,
                                                double lineForce, double velocity);

}  // namespace asperity
