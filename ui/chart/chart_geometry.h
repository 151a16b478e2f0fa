// Positions in the frame of a diagram, the object under the pointer, and zooming and panning. Pure
// values, without widgets; any thread.
#pragma once

#include <QPointF>
#include <QRectF>
#include <vector>

#include "core/chart/diagram.h"
#include "ui/draw/draw_list.h"

namespace asperity {

/// A range on an axis: decimal logarithms on a logarithmic one, otherwise values.
struct AxisRange {
  double from = 0, to = 0;

  bool isEmpty() const { return to <= from; }
  double size() const { return to - from; }
  bool operator==(const AxisRange&) const = default;
};

/// The visible ranges of a chart: of the x-axis that all its diagrams share, and of the first
/// diagram's y-axis.
struct VisibleRange {
  AxisRange x, y;

  bool operator==(const VisibleRange&) const = default;
};

/// Length in pixels, times the scale, by which a frame on the screen extends beyond the ends of its
/// x-axis, so that marks there are complete.
inline constexpr double kFrameEdge = 6;

/// Distance in pixels, times the scale, below the axis of a value that a logarithmic axis cannot
/// show: a curve through 0 leaves the frame there.
inline constexpr double kBelowAxis = 10;

/// Maps the values of one diagram to positions inside its frame, on the screen or in a picture.
struct ChartGeometry {
  QRectF area;
  AxisRange x, y;
  AxisScale xScale = AxisScale::Logarithmic, yScale = AxisScale::Logarithmic;
  double names = 18;  // pixels, height of the names of regions above the frame
  double scale = 1;   // factor of marks and pens, which grow with the font

  /// Returns the frame on the screen, which is a little wider than the axes.
  QRectF frame() const { return area.adjusted(-kFrameEdge * scale, 0, kFrameEdge * scale, 0); }
  /// Returns the position of a pair of values; NaN for values that the axes cannot show.
  QPointF at(double xValue, double yValue) const;
  double mapX(double value) const;
  /// Returns the middle of the column of pixels at this value, where error bars are sharp and marks
  /// lie on them.
  double columnAt(double value) const;
  double mapY(double value) const;
  /// These functions return the values at a pixel.
  double xAt(double pixel) const;
  double yAt(double pixel) const;
  /// These functions do the same for positions on the axes (AxisRange) instead of values.
  double pixelX(double position) const;
  double pixelY(double position) const;
  double positionX(double pixel) const;
  double positionY(double pixel) const;
};

/// Returns a rectangle as pictures have it.
Box toBox(const QRectF& rect);

/// Returns whether a position is one: false for those of values that the axes cannot show.
bool isFinite(QPointF position);

/// The nearest objects of each kind under the pointer, as indices in the diagram.
struct ChartTarget {
  bool isMarker = false;
  int diagram = -1, series = -1, point = -1;
  int span = -1;  // index of a region name above the first diagram

  bool isPoint() const { return point >= 0; }
  bool operator==(const ChartTarget&) const = default;
};

/// Distance in pixels at which a marker and a point can be gripped, times the scale of a geometry.
inline constexpr double kMarkerReach = 6, kPointReach = 9;

/// Returns the objects at a position. There is one geometry for each diagram of the sheet. Only
/// points of a series with an id can be pointed at; in diagrams below the first, which are too low
/// for aiming, the point with the nearest x is chosen.
ChartTarget targetAt(const std::vector<ChartGeometry>& geometries, const DiagramSheet& sheet,
                     QPointF position);

/// These functions return the series, and the point in it, that is the target in this sheet.
const DiagramSeries& targetSeries(const DiagramSheet& sheet, const ChartTarget& target);
const DiagramPoint& targetPoint(const DiagramSheet& sheet, const ChartTarget& target);

/// The axes that a zoom changes.
struct ZoomAxes {
  bool x = false, y = false;
};
/// Returns the axes that the wheel zooms at this position: both inside the frame, one over its
/// labels, none elsewhere.
ZoomAxes axesAt(const ChartGeometry& geometry, QPointF position);

/// Zooms about a position, which stays fixed: the range becomes `factor` times as wide, within 0.1
/// to 60 decades.
VisibleRange zoomed(const ChartGeometry& geometry, QPointF about, double factor, ZoomAxes axes);

/// Moves the range by this many pixels.
VisibleRange panned(const ChartGeometry& geometry, QPointF by);

/// Moves the range as little as possible so that on each axis at least half of it lies within
/// `whole`.
VisibleRange clampedTo(const VisibleRange& range, const VisibleRange& whole);

/// Returns the nearest point beyond a value of x among the series with this id; null where there is
/// none.
const DiagramPoint* nextPoint(const Diagram& diagram, int id, double x, bool isForward);

/// Returns whether any curve of the diagram passes through the range.
bool showsCurves(const VisibleRange& range, const Diagram& diagram);

}  // namespace asperity
