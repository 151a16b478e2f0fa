// The parts of the friction diagram, each made from one curve: series, regions, the strip of a
// difference, and the reading of a point. Pure; texts through Qt's translation. One thread.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <vector>

#include "core/chart/curve_set.h"
#include "core/run/runner.h"
#include "ui/chart/plot.h"

namespace asperity {

/// Whether two scenes have the same averaged curve: all but titles and motion agree.
bool haveSameCurve(const Scene& a, const Scene& b);

class FrictionSeries {
  Q_DECLARE_TR_FUNCTIONS(asperity::FrictionSeries)

 public:
  /// Only points that are known and have a place.
  static PlotSeries measured(const CurveUpdate& curve, CurveAxes axes);
  static PlotSeries law(const CurveUpdate& curve, CurveAxes axes);
  static PlotSeries pinned(const CurveUpdate& curve, CurveAxes axes, int id, int place,
                           const QString& name);
  static std::vector<PlotSpan> regions(const CurveUpdate& curve, CurveAxes axes);
  static std::vector<PlotSpan> shades(const CurveUpdate& curve, CurveAxes axes);
  static PlotStrip strip(const CurveDifference& difference, const CurveUpdate& curve,
                         CurveAxes axes);

  /// "G = 20 MPa (37 of 200 lines)": in what a curve's scene differs.
  static QString nameOfPinned(const CurveUpdate& curve, const Scene& present);

  /// Lines that tell all about a point.
  static QString reading(const CurvePoint& point, CurveAxes axes);
  static QString reading(const DifferencePoint& point, const CurveSetting& setting);

  static bool isOneLine(const CurveUpdate& curve) { return curve.realizationsTotal <= 1; }
};

}  // namespace asperity
