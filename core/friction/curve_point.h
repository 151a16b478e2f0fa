// One row of a friction curve. Plain values; the columns of interface.md in the same order.
#pragma once

#include <cstdint>
#include <limits>

namespace asperity {

/// Not applicable: empty in CSV, null in JSON, not drawn.
inline constexpr double kNotApplicable = std::numeric_limits<double>::quiet_NaN();

struct CurvePoint {
  double velocity = 0;                            // m/s
  double mu = 0;                                  // mean over realizations
  double muStandardError = kNotApplicable;        // of that mean; needs two realizations
  double muLaw = kNotApplicable;                  // Eq. (11)
  double contactFraction = 0;                     // L_cont / L
  double rmsSlopeContact = kNotApplicable;        // grad z_cont
  double indentation = 0;                         // m, d above the line's lowest point
  double normalizedMu = kNotApplicable;           // mean of mu / rms slope of the whole line
  double dimensionlessVelocity = kNotApplicable;  // Eq. (13)
  double dimensionlessForce = kNotApplicable;     // Eq. (14)
  std::int64_t realizations = 0;
  double muLow = kNotApplicable;   // 95 % confidence interval of mu, resolution included; of curves
  double muHigh = kNotApplicable;  // to a target accuracy
  double muInterface = kNotApplicable;  // of local friction, where the scene has some; beside mu
  /// Mean tangential over mean normal force, where lines carry different forces: at a constant
  /// indentation. mu is the mean of the lines' own ratios.
  double muRatioOfMeans = kNotApplicable;
  /// Of `nodal`: mean over realizations of the share of its load that the element on the edge of
  /// contact bears, where F_N(d) jumps past the force; 1 where it does not jump.
  double marginalShare = kNotApplicable;
};

}  // namespace asperity
