// The analytical law of friction: Eqs. (5) to (9), (11), (13) and (14) of Li et al., PRL 111,
// 034301 (2013), each as one function under its number. Pure; SI units; slopes are root mean
// squares. Eq. (10) leads to Eq. (9), whose sqrt(2) assumes exponentially distributed slopes;
// random phases give Gaussian ones, and sqrt(pi / 2). Eq. (12) is Eq. (11) without dimensions for
// beta = 1, and is up to 1.95 times below Eq. (11) with the measured beta.
#pragma once

#include "core/material/element_law.h"
#include "core/surface/line.h"

namespace asperity {

struct LawInput {
  double shearModulus = 0;    // Pa, G
  double relaxationTime = 0;  // s, tau = eta / G
  double length = 0;          // m, L
  double rmsHeight = 0;       // m, h
  double rmsSlope = 0;        // of the line, or of the line in contact where known
  double hurst = 0;           // H
  double normalForce = 0;     // N
  double velocity = 0;        // m/s
};

/// Returns the input for lines with these statistics, of length (m) and Hurst exponent, under a
/// normal force (N) on one period. For an element with arms, Eq. (14) holds with its equilibrium
/// modulus; Eqs. (5) to (13) need the only relaxation time of Kelvin's element.
inline LawInput lawInput(const ElementLaw& law, const LineStatistics& lines, double length,
                         double hurst, double normalForce, double velocity) {
  return {law.equilibriumModulus,
          law.relaxationTime,
          length,
          lines.rmsHeight,
          lines.rmsSlope,
          hurst,
          normalForce,
          velocity};
}

/// Eq. (5): mu = beta tau v grad^2 / h (G h L / F_N)^alpha, at low velocities and partial contact.
double lowVelocityFriction(const LawInput& in, double alpha, double beta);

/// Eq. (6): mu = 4 L_cont eta grad_cont^2 v / F_N; contactLength in m, slope of the line in
/// contact.
double contactFriction(const LawInput& in, double contactLength, double rmsSlopeContact);

/// Eq. (7): alpha = H / (1 + H).
double forceExponent(double hurst);

/// Eq. (8): Eq. (6) with the whole line in contact.
double fullContactFriction(const LawInput& in);

/// Eq. (9): mu = sqrt(2) grad_cont.
double plateauFriction(double rmsSlopeContact);

/// Eq. (11) with alpha from Eq. (7).
double frictionLaw(const LawInput& in, double beta);

/// Eq. (11) with the measured beta(H) of lawPrefactor.
double frictionLaw(const LawInput& in);

/// Eq. (13): tau v grad / (sqrt(2) h).
double dimensionlessVelocity(const LawInput& in);

/// Eq. (14): F_N / (G h L).
double dimensionlessForce(const LawInput& in);

/// Returns the prefactor beta of Eq. (5) with alpha = H / (1 + H), measured on the resolved line of
/// 5000 elements in the limit of low velocity: the mean of ln(mu ...) over 1e-3 <= F_N / G h L <=
/// 1, interpolated in H. It has a standard error of 0.3 %; inside the window Eq. (5) itself is
/// accurate to 10 %.
double lawPrefactor(double hurst);

}  // namespace asperity
