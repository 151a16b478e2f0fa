// A line with Gaussian heights on a foundation of independent elements, in the limit of low
// velocity. There the elastomer under a contact is as at rest: an element at height z above the
// mean line is in contact where z < depth, its pressure is 4 G (depth - z), and what its dashpots
// lose is 4 eta v z'^2. With heights and slopes independent and Gaussian (Longuet-Higgins 1957;
// Greenwood and Williamson, Proc. R. Soc. A 295, 300 (1966), for the mean over a normal density),
//   F_N / (4 G h L) = phi(delta) + delta Phi(delta),   L_c / L = Phi(delta),
//   mu = 4 eta v L Phi(delta) <z'^2> / F_N,
// delta being the depth of the mean line below the undeformed surface over the rms height h, phi
// and Phi the normal density and distribution. No constant is fitted.
// Range: low velocity, and so many independent waves that every line has its share of summits:
// three of them in contact (theory.cpp). Pure; any thread. For a Prony series G is the equilibrium
// modulus, and eta = eta_0 + sum G_i tau_i, the loss modulus over the frequency as it goes to 0.
#pragma once

#include "core/material/element_law.h"

namespace asperity {

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

}  // namespace asperity
