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
  RunningMean mu, muInterface, contactFraction, rmsSlopeContact, indentation, normalForce,
      tangentialForce, marginalShare;
  RunningMean rmsSlope, normalizedMu;  // of the whole line, and mu over that of its own line

  /// Pressed by nothing a line has no coefficient; what is averaged is counted.
  void add(const SteadyResult& result);
  /// With contact, slope and indentation, and mu and its realizations.
  CurvePoint point(double velocity) const;
};

/// Eqs. (5) to (14) for the lines of a scene. Pure after construction.
class LawColumns {
 public:
  LawColumns(const Scene& scene, const LineSource& source);

  /// Adds muLaw, normalizedMu and the dimensionless numbers; takes away muInterface where the scene
  /// has no local friction, muRatioOfMeans where it gives the force, and marginalShare where the
  /// scheme is not nodal. Lines that differ in their slope are normalized each by its own.
  void addTo(CurvePoint& point, const CurveAverages& averages) const;

 private:
  double normalized(double mu, const CurveAverages& averages) const;

  Scene scene_;
  LineStatistics line_;
  double length_;  // m
  bool isRandom_, hasArms_, hasInterface_;
  bool slopesDiffer_;  // from line to line
};

}  // namespace asperity
