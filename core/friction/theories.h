// Theories of the friction of a rough line on a linear viscoelastic body, without a fitted
// constant: complete contact, the foundation at low velocity, and the half-space of Persson. Each
// needs the spectrum of the line alone. core/friction/theory_curve.h draws them beside a friction
// curve. For a Prony series G is the equilibrium modulus. Plain values; pure functions; any thread.
#pragma once

#include <vector>

#include "core/material/element_law.h"
#include "core/surface/line_source.h"

namespace asperity {

// ---- The spectrum of a scene's line: mean squares of its waves without phases
/// One wave of the line z = sum a_k cos(q_k x + phase_k).
struct SpectralWave {
  double waveNumber = 0;        // 1/m, q_k
  double meanSquareHeight = 0;  // m^2, a_k^2 / 2 = 2 C(q_k) dq
};

struct WaveSpectrum {
  std::vector<SpectralWave> waves;  // rising wave numbers

  double meanSquareHeight() const;  // m^2, <h^2>
  double meanSquareSlope() const;   // <z'^2>
  /// Returns how many waves of one height would have heights as far from Gaussian ones as these
  /// have: the square of the sum of their mean square heights over the sum of the squares.
  double effectiveWaves() const;
};

/// Returns the spectrum of realization 0. Random lines differ only in their phases, unless the
/// scene has a summit correlation. A line given by a formula is analysed at its nodes.
WaveSpectrum waveSpectrum(const LineSource& source);

// ---- Complete contact, for any linear rheology. The surface of the elastomer is the line itself,
// each wave of it is a harmonic deformation at the angular frequency q v, and the losses of all
// waves add up:
//   mu F_N = 2 L integral_0^inf q C(q) 4 G''(q v) dq.
// The pressure is p = F_N / L + 4 sum |G*(q v)| times the waves; contact is complete where it is
// above 0 everywhere.
struct CompleteContactFriction {
  double mu = 0;
  double rmsPressure = 0;  // N/m, of the pressure's variation about its mean F_N / L
};

/// Returns the friction at a velocity (m/s). lineForce: F_N / L in N/m, above 0.
CompleteContactFriction completeContactFriction(const ElementLaw& law, const WaveSpectrum& spectrum,
                                                double lineForce, double velocity);

// ---- A line with Gaussian heights on a foundation of independent elements, in the limit of low
// velocity. There the elastomer under a contact is as at rest: an element at height z above the
// mean line is in contact where z < depth, its pressure is 4 G (depth - z), and what its dashpots
// lose is 4 eta v z'^2. With heights and slopes independent and Gaussian (Longuet-Higgins 1957;
// Greenwood and Williamson, Proc. R. Soc. A 295, 300 (1966), for the mean over a normal density),
//   F_N / (4 G h L) = phi(delta) + delta Phi(delta),   L_c / L = Phi(delta),
//   mu = 4 eta v L Phi(delta) <z'^2> / F_N,
// delta being the depth of the mean line below the undeformed surface over the rms height h, phi
// and Phi the normal density and distribution, and eta = eta_0 + sum G_i tau_i, the loss modulus
// over the frequency as it goes to 0.
// Range: low velocity, and so many independent waves that every line has its share of summits:
// three of them in contact (theory_curve.cpp).
/// Returns F_N / (4 G h L) at the relative depth delta.
double gaussianLoad(double delta);

/// Returns the relative depth at which F_N / (4 G h L) = load > 0, to rounding.
double gaussianDepth(double load);

/// Returns L_c / L = Phi(delta).
double gaussianContactFraction(double delta);

/// Returns the viscosity in the limit of low frequency, Pa s: the loss modulus over the angular
/// frequency as it tends to 0.
double zeroFrequencyViscosity(const ElementLaw& law);

struct GaussianFoundation {
  double slope = 0;            // s/m: mu = slope v
  double contactFraction = 0;  // L_c / L
  /// m/s: up to here mu is within 5 % of a curve that bends into the plateau sqrt(pi/2) grad of
  /// Gaussian slopes in one-sided contact, 1/mu^2 = 1/(slope v)^2 + 1/plateau^2.
  double validBelow = 0;
};

/// lineForce: F_N / L in N/m, above 0. Needs an equilibrium modulus and roughness: without, NaN.
GaussianFoundation gaussianFoundation(const ElementLaw& law, double meanSquareHeight,
                                      double meanSquareSlope, double lineForce);

// ---- Persson's theory of rubber friction, J. Chem. Phys. 115, 3840 (2001), on the half-space
// whose isotropic surface has the line of the scene as its equivalent: C2(q) = C_line(q) / (pi q)
// (Popov and Hess, Method of Dimensionality Reduction, ch. 10). Elements of a half-space feel each
// other, those of the foundation do not: this is another model, with long-range elasticity.
//   mu = 1/2 int dq q^3 C2 S P int_0^2pi dphi cos phi Im E(q v cos phi) / ((1 - nu^2) sigma_0)
//   P(q) = erf(1 / (2 sqrt g)),  S = gamma + (1 - gamma) P^2, gamma = 1/2
//   g(q) = 1/8 int_0^q dq q^3 C2 int_0^2pi dphi |E(q v cos phi) / ((1 - nu^2) sigma_0)|^2
// Rubber is incompressible: E / (1 - nu^2) = 4 G*. P at the largest q is the contact fraction. With
// the prefactor 1/8 a light load on an elastic solid has P = sqrt(8/pi) sigma_0 / (E* grad), and
// with P = S = 1 the friction is that of complete contact. S is the correction of Persson's later
// papers for the smaller strains in partial contact, where gamma is about 1/2.
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
