// The parts of a diagram that Qt Charts cannot paint, as items under and over its series
// (chart_panel.h gives the reason). Graphics items; GUI thread.
#pragma once

#include <QGraphicsItem>
#include <QList>
#include <QString>
#include <vector>

#include "core/base/statistics.h"
#include "core/chart/diagram.h"
#include "ui/chart/chart_geometry.h"
#include "ui/chart/chart_style.h"
#include "ui/chart/diagram_axes.h"
#include "ui/chart/occupancy_grid.h"

namespace asperity {

/// Returns what the series of a diagram cover inside its frame.
OccupancyGrid coveredBySeries(const Diagram& diagram, const ChartGeometry& map,
                              const ChartStyle& style);

/// Where a chart shows the titles of its axes.
struct AxisTitles {
  bool hasX = true, hasY = true;  // false: a widget outside of the chart shows the title
  bool hasXLabels = true;         // labels and title of the x-axis are below the frame
  // The title of the y-axis is upright on the left, except:
  double beside = 0;     // on the right and this many pixels wide; 0: it is not there
  bool isAbove = false;  // level above the frame
};

/// Paints regions with their names, shades, the grid, the frame and the titles of the axes.
class ChartBackground : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void show(const Diagram& diagram, const ChartGeometry& map, const ChartStyle& style,
            const TickedAxis& xAxis, const TickedAxis& yAxis, const AxisTitles& titles);

  /// Keeps the names of shades away from an upright line; NaN: there is none.
  void avoid(double x);
  /// Returns the rectangles of the names of shades, which are inside the frame.
  QList<QRectF> namesInside() const;
  /// Returns the whole title of the x-axis if it is shown shortened, otherwise an empty text.
  QString elidedTitle() const;

  QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

 private:
  /// The position of the name of a shade.
  struct Name {
    QRectF area;
    int alignment = 0;
    QRectF box{};  // empty where it does not fit
  };

  QRectF spanRect(const DiagramSpan& span) const;
  Name shadeName(const DiagramSpan& shade) const;
  Name nameIn(const QRectF& area, int side, const DiagramSpan& shade) const;
  QRectF labelBox(const QRectF& area, int alignment, const DiagramSpan& shade) const;
  FittedTitle xTitle() const;
  void paintNumbers(QPainter& painter) const;
  void paintSpans(QPainter& painter) const;
  void paintShadeNames(QPainter& painter) const;
  /// These functions return a line across the x-axis, or across the y-axis, on whole pixels.
  QLineF upright(double position, double from, double to) const;
  QLineF level(double position, double from, double to) const;
  void paintGrid(QPainter& painter) const;
  void paintFrame(QPainter& painter) const;
  void paintTitles(QPainter& painter) const;

  std::vector<DiagramSpan> spans_, shades_;
  OccupancyGrid covered_{{}, 1};  // the area that the series cover
  ChartGeometry map_;
  ChartStyle style_;
  TickedAxis xAxis_, yAxis_;
  AxisTitles titles_;
  double line_ = kNaN;  // that names avoid
  QRectF frame_;
};

/// Paints error bars, or the reason why there are no curves.
class ChartForeground : public QGraphicsItem {
 public:
  using QGraphicsItem::QGraphicsItem;

  void show(const Diagram& diagram, const ChartGeometry& map, const ChartStyle& style);

  /// Returns the rectangle of the sentence that explains why there are no curves; empty where there
  /// is none.
  QRectF sentence() const;

  QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

 private:
  struct Bars {
    QColor colour;
    double opacity = 1;
    QList<QLineF> lines;  // from the high end to the low end
  };

  QRectF sentenceArea() const;

  std::vector<Bars> bars_;
  ChartGeometry map_;
  ChartStyle style_;
  QString blank_;
};

}  // namespace asperity
