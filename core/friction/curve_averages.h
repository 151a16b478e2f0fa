// What the rows of a friction curve are made of: averages over realizations at one velocity, and
// the columns that come from the analytical law. Used by every way to compute a curve.
#pragma once

#include "core/contact/steady_sliding.h"
#include "core/friction/curve_point.h"
#include "core/friction/running_mean.h"
#include "core/scene/scene.h"
#include "core/surface/line_source.h"

namespace asperity {

/// Averages of everything in a row but mu's standard error.
struct CurveAverages {
  RunningMean mu, muInterface, contactFraction, rmsSlopeContact, indentation, normalForce;
  RunningMean marginalShare;

  /// Pressed by nothing a line has no coefficient; what is averaged is counted.
  void add(const SteadyResult& result);
  /// With contact, slope and indentation, and mu and its realizations.
  CurvePoint point(double velocity) const;
};

/// Eqs. (5) to (14) for the lines of a scene. Pure after construction.
class LawColumns {
 public:
  LawColumns(const Scene& scene, const LineSource& source);

  /// Adds muLaw, normalizedMu and the dimensionless numbers; takes muInterface and
  /// marginalShare away where the scene has no local friction or another scheme than nodal.
  /// meanForce: N, where the scene gives an indentation instead of a force.
  void addTo(CurvePoint& point, double meanForce) const;

 private:
  Scene scene_;
  LineStatistics line_;
  double length_;  // m
  bool isRandom_, hasArms_, hasInterface_;
};

}  // namespace asperity
