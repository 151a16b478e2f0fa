// Where things of a plot are in pixels, what lies under the pointer, and how the view is zoomed and
// panned. Pure values, without widgets; any thread.
#pragma once

#include <QPointF>
#include <QRectF>
#include <optional>

#include "ui/chart/plot.h"

namespace asperity {

/// Least height of the names above the plot area, pixels.
inline constexpr double kSpanNames = 18;

/// Maps values to positions inside the plot area, both axes logarithmic; below it lies the strip.
struct PlotGeometry {
  QRectF area;
  DecadeRange x, y;
  QRectF strip{};             // empty: none
  double names = kSpanNames;  // pixels, height of the names above
  double scale = 1;           // of marks and pens, which grow with large letters

  double xOf(double value) const;
  double yOf(double value) const;
  /// The value at a place along x.
  double valueAt(double pixel) const;
};

/// What lies under the pointer; the nearest of its kind.
struct PlotTarget {
  bool isMarker = false;
  int series = -1, point = -1;  // index of the series and of its point
  int stripPoint = -1;
  int span = -1;  // of the names above the plot area

  bool isPoint() const { return point >= 0; }
  bool operator==(const PlotTarget&) const = default;
};

/// Pixels from which a marker and a point can be gripped, times the scale of a geometry.
inline constexpr double kMarkerReach = 6, kPointReach = 9;

PlotTarget targetAt(const PlotGeometry& geometry, const Plot& plot, QPointF place);

/// Which axes a turn of the wheel there is for: both inside, one at its labels, none elsewhere.
struct ZoomAxes {
  bool x = false, y = false;
};
ZoomAxes axesAt(const PlotGeometry& geometry, QPointF place);

/// Seen `factor` times as wide about a place, which stays where it is; within 0.1 to 60 decades.
PlotWindow zoomed(const PlotGeometry& geometry, QPointF about, double factor, ZoomAxes axes);

/// Moved with the pointer by so many pixels.
PlotWindow panned(const PlotGeometry& geometry, QPointF by);

/// The window, or the nearest of its size of which on each axis at least a half shows a part of
/// `whole`, or all of it.
PlotWindow heldWithin(const PlotWindow& window, const PlotWindow& whole);

/// Whether any curve of the plot passes through the window.
bool showsCurves(const PlotWindow& window, const Plot& plot);

}  // namespace asperity
