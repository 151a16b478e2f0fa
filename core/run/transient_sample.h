// One sample of a motion that is not steady. Plain value.
#pragma once

#include "core/friction/curve_point.h"

namespace asperity {

/// Means over the steps since the previous sample.
struct TransientSample {
  double time = 0;         // s, at its end
  double velocity = 0;     // m/s, mean; below 0 the line moves backwards
  double distance = 0;     // m, slid so far
  double indentation = 0;  // m
  double normalForce = 0;  // N
  /// N, integral of p z' dx = -F_x: it has the sign of the velocity where it resists. Defined also
  /// at rest, while contact is still one-sided.
  double tangentialForce = 0;
  double mu = kNotApplicable;  // magnitude of friction over normal force; NaN without normal force
  double muError = kNotApplicable;  // estimated discretization error; NaN where it is unknown
  double muInterface = 0;           // of local friction, 0 at rest
  double powerDissipated = 0;       // W, in the dashpots of all elements
  double contactFraction = 0;
  double contactSpots = 0;   // stretches in contact
  double contactLength = 0;  // m, mean of one stretch in contact
  /// 1/s, rate at which friction is expected to relax: 1 / tau + |v| / contactLength. Exact to
  /// about 1 % for one contact of Kelvin elements at constant force; approximate on rough lines.
  /// NaN for others.
  double predictedRate = kNotApplicable;
};

}  // namespace asperity
