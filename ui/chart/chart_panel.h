// One diagram of the interactive chart. Qt Charts draws its axes with their labels and its series:
// curves (QLineSeries), marks (QScatterSeries) and bands (QAreaSeries), whose points are replaced
// when the diagram changes. What Qt Charts cannot do is painted by two items under and over the
// series (chart_items.h), for these reasons:
// - ticks: its logarithmic axis has none between decades, and cannot have our labels. Therefore the
//   axes hold decimal logarithms (or plain values) under the labels that every picture has.
// - the grid, the frame and its tick marks: a QCategoryAxis has no lines between its labels, and
//   lines between pixels are faint, and look thick beside those of the frame.
// - regions: it shades whole intervals between labels, and does not name them.
// - error bars: its lines do not break, so that each bar would need a series of its own.
// - titles: they are cut even where there is enough space.
// GUI thread.
#pragma once

#include <QString>
#include <vector>

#include "core/chart/diagram.h"
#include "ui/chart/chart_geometry.h"
#include "ui/chart/chart_items.h"
#include "ui/chart/chart_style.h"

class QAreaSeries;
class QCategoryAxis;
class QChart;
class QGraphicsScene;
class QLineSeries;
class QScatterSeries;

namespace asperity {

class ChartPanel {
 public:
  explicit ChartPanel(QGraphicsScene& scene);
  ~ChartPanel();
  ChartPanel(const ChartPanel&) = delete;
  ChartPanel& operator=(const ChartPanel&) = delete;

  void show(const Diagram& diagram, const ChartGeometry& geometry, const ChartStyle& style,
            const AxisTitles& titles);

  /// Returns the titles with their units as they fit the visible range.
  const QString& xTitle() const { return xTitle_; }
  const QString& yTitle() const { return yTitle_; }

  /// Keeps the names of shades away from an upright line at x, which is the marker's; NaN: none.
  void avoidLine(double x);

  /// Returns the rectangles of the names of shades, which are inside the frame.
  QList<QRectF> namesInside() const;

  /// Returns the rectangle of the sentence that explains why there are no curves; empty where there
  /// is none.
  QRectF sentence() const;

  /// Returns the whole title of the x-axis if it is shown shortened, otherwise an empty text.
  QString elidedTitle() const;

 private:
  void showAxis(QCategoryAxis& axis, const TickedAxis& ticked, const AxisRange& range);
  void applyStyle(QCategoryAxis& axis, const ChartStyle& style);
  void showSeries(const Diagram& diagram, const ChartGeometry& geometry, const ChartStyle& style);
  void showBand(const DiagramSeries& series, const Diagram& diagram, const ChartStyle& style);
  void showRun(const DiagramSeries& series, const QList<QPointF>& run, const ChartStyle& style);
  void showMarks(const DiagramSeries& series, const QList<QPointF>& positions, double width,
                 const ChartStyle& style);
  QScatterSeries& nextMarks();
  QLineSeries& nextLine();
  QAreaSeries& nextBand();
  template <class Series>
  Series* addToChart(Series* series);

  QChart* chart_;  // owned by the graphics scene
  QCategoryAxis *x_, *y_;
  // The chart owns these; the first ones of each list are in use.
  std::vector<QLineSeries*> lines_;
  std::vector<QScatterSeries*> marks_;
  std::vector<QAreaSeries*> bands_;
  std::size_t linesUsed_ = 0, marksUsed_ = 0, bandsUsed_ = 0;
  QString xTitle_, yTitle_;
  ChartBackground* under_;
  ChartForeground* over_;
};

}  // namespace asperity
