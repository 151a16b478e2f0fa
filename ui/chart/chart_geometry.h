// Where things of a diagram are in pixels of the interactive chart, what lies under the pointer,
// and how its view is zoomed and panned. Pure values, without widgets; any thread.
#pragma once

#include <QPointF>
#include <QRectF>
#include <vector>

#include "core/chart/diagram.h"
#include "ui/chart/diagram_axes.h"

namespace asperity {

/// What is shown of a chart: the axis that all its diagrams share, and the first one's own.
struct VisibleRange {
  AxisRange x, y;

  bool operator==(const VisibleRange&) const = default;
};

/// Maps the values of one diagram to positions inside its frame.
struct ChartGeometry {
  QRectF area;
  AxisRange x, y;
  AxisScale xScale = AxisScale::Logarithmic, yScale = AxisScale::Logarithmic;
  double names = 18;  // pixels, height of the names of regions above
  double scale = 1;   // of marks and pens, which grow with large letters

  /// Values without a place on the axes give NaN.
  QPointF at(double xValue, double yValue) const;
  double xOf(double value) const;
  double yOf(double value) const;
  /// The value at a place along x.
  double valueAt(double pixel) const;
};

/// Whether a point has a place on the axes of its diagram.
bool hasPlace(const Diagram& diagram, const DiagramPoint& point);

/// What lies under the pointer; the nearest of its kind. Indices in the diagram.
struct ChartTarget {
  bool isMarker = false;
  int diagram = -1, series = -1, point = -1;
  int span = -1;  // of the names above the first diagram

  bool isPoint() const { return point >= 0; }
  bool operator==(const ChartTarget&) const = default;
};

/// Pixels from which a marker and a point can be gripped, times the scale of a geometry.
inline constexpr double kMarkerReach = 6, kPointReach = 9;

/// One geometry for each diagram of the sheet. Only points of a series with an id can be pointed
/// at; in diagrams below the first, which are too slim to aim in, the nearest along x counts.
ChartTarget targetAt(const std::vector<ChartGeometry>& geometries, const DiagramSheet& sheet,
                     QPointF place);

/// Returns the axes that the wheel zooms at this place: both inside the frame, one at its labels,
/// none elsewhere.
struct ZoomAxes {
  bool x = false, y = false;
};
ZoomAxes axesAt(const ChartGeometry& geometry, QPointF place);

/// Zooms about a place, which stays where it is: the range becomes `factor` times as wide, within
/// 0.1 to 60 decades.
VisibleRange zoomed(const ChartGeometry& geometry, QPointF about, double factor, ZoomAxes axes);

/// Moves the range by this many pixels.
VisibleRange panned(const ChartGeometry& geometry, QPointF by);

/// Moves the range as little as possible so that on each axis at least half of it lies within
/// `whole`.
VisibleRange heldWithin(const VisibleRange& window, const VisibleRange& whole);

/// Whether any curve of the diagram passes through the window.
bool showsCurves(const VisibleRange& window, const Diagram& diagram);

}  // namespace asperity
