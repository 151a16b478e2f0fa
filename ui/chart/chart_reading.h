// What the pointer reads in a chart: the reading of a point, and the explanation of a region, a
// shade or a curve. Pure; the window's thread (the language may change).
#pragma once

#include <QList>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "core/chart/diagram.h"
#include "core/chart/explanations.h"
#include "ui/chart/chart_geometry.h"

namespace asperity {

/// A chart as it is on the screen.
struct ReadableChart {
  const DiagramSheet& english;  // by its names explanations are found
  const DiagramSheet& sheet;    // in the current language
  const std::vector<ChartGeometry>& frames;
  QList<QRectF> shadeNames{};  // the rectangles of the names of shades, in the first diagram
  QString cutTitle{};          // of the x-axis, where it is shown shortened
};

/// Returns the reading of a point, given by its series' id and its row. May be empty.
using DescribePoint = std::function<QString(int id, int row)>;

/// Returns the explanation of the region, the shade or the curve at a position.
std::optional<HoverExplanation> explanationAt(const ReadableChart& chart, const ChartTarget& target,
                                              QPointF position);

/// Returns the text of the tip at a position; empty where there is nothing to read.
QString tipText(const ReadableChart& chart, const ChartTarget& target, QPointF position,
                const DescribePoint& describe);

/// Returns what the pointer may go to from this object: the other points of its diagram, or the row
/// of the names of regions.
QList<QRectF> neighbours(const ReadableChart& chart, const ChartTarget& target);

}  // namespace asperity
