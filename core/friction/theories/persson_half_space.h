// Persson's theory of rubber friction, J. Chem. Phys. 115, 3840 (2001), on the half-space whose
// isotropic surface has the line of the scene as its equivalent: C2(q) = C_line(q) / (pi q)
// (Popov and Hess, Method of Dimensionality Reduction, ch. 10). Elements of a half-space feel each
// other, those of the foundation do not: this is another model, with long-range elasticity.
//   mu = 1/2 int dq q^3 C2 S P int_0^2pi dphi cos phi Im E(q v cos phi) / ((1 - nu^2) sigma_0)
//   P(q) = erf(1 / (2 sqrt g)),  S = gamma + (1 - gamma) P^2, gamma = 1/2
//   g(q) = 1/8 int_0^q dq q^3 C2 int_0^2pi dphi |E(q v cos phi) / ((1 - nu^2) sigma_0)|^2
// Rubber is incompressible: E / (1 - nu^2) = 4 G*. P at the largest q is the contact fraction. With
// the prefactor 1/8 a light load on an elastic solid has P = sqrt(8/pi) sigma_0 / (E* grad), and
// with P = S = 1 the friction is that of complete contact. S is the correction of Persson's later
// papers for the smaller strains in partial contact, where gamma is about 1/2.
// Pure; any thread.
#pragma once

#include <vector>

#include "core/friction/theories/line_spectrum.h"

namespace asperity {

/// Both integrals over the direction of a wave, exactly, at the angular frequency w = q v along the
/// direction of sliding: with a = w tau every Maxwell arm has closed integrals.
struct DirectionIntegrals {
  double loss = 0;     // Pa, int_0^2pi cos phi G''(w cos phi) dphi
  double squared = 0;  // Pa^2, int_0^2pi |G*(w cos phi)|^2 dphi
};

class PerssonHalfSpace {
 public:
  /// nominalPressure: sigma_0 in Pa, above 0. The spectrum must outlive it.
  PerssonHalfSpace(const ElementLaw& law, const WaveSpectrum& spectrum, double nominalPressure);

  struct Result {
    double mu = 0;
    double contactFraction = 0;  // of the nominal area, at the resolution of the shortest wave
  };
  Result at(double velocity) const;

  DirectionIntegrals directionIntegrals(double frequency) const;

 private:
  const ElementLaw& law_;
  const WaveSpectrum& spectrum_;
  double pressure_;              // Pa, sigma_0
  double glassy_;                // Pa, all springs together
  std::vector<double> coupled_;  // Pa^2, of each arm: G_i (sum_j 2 G_j tau_i / (tau_i + tau_j) -
                                 // 2 glassy)
};

}  // namespace asperity
