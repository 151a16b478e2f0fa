// One diagram of the interactive chart. Qt Charts draws its axes with their labels and its series:
// curves (QLineSeries), marks (QScatterSeries) and bands (QAreaSeries), whose points are replaced
// when the diagram changes. What Qt Charts cannot do is painted here, in two items under and over
// the series, for these reasons:
// - ticks: its logarithmic axis drops those between decades, and has no labels of our kind. So the
//   axes hold decimal logarithms (or plain values) under the labels that every picture has.
// - the grid: a QCategoryAxis has no lines between its labels, and lines between pixels are dull.
// - regions: it shades whole stretches between labels, and names none.
// - error bars: its lines do not break, so that each bar would need a series of its own.
// - titles: they are cut where they have room.
// GUI thread.
#pragma once

#include <QColor>
#include <QFont>
#include <QImage>
#include <QString>
#include <vector>

#include "core/chart/diagram.h"
#include "ui/chart/chart_geometry.h"
#include "ui/draw/theme.h"

class QAreaSeries;
class QCategoryAxis;
class QChart;
class QGraphicsItem;
class QGraphicsScene;
class QLineSeries;
class QPainter;
class QScatterSeries;

namespace asperity {

/// How a chart looks: the colours of its theme, and letters, with which marks and pens grow.
struct ChartLook {
  Theme theme = lightTheme();
  QFont font{};
  bool showsFocus = false;

  QColor background() const;
  QColor text() const;
  QColor faintText() const;
  QColor axis() const;
  QColor grid() const;      // at labels
  QColor fineGrid() const;  // between them
  QColor span() const;      // every other region
  QColor shade() const;     // a tint, with its transparency
  QColor marker() const;
  QColor of(const DiagramSeries& series) const;
  double scale() const;  // at least 1
  double line() const;   // pixels, height of a line of text
};

/// Opacity of what belongs to a state that is over.
inline constexpr double kFadedOpacity = 0.3;

/// Pixels, times the scale, that a frame reaches beyond the ends of its axis along, so that marks
/// there are whole.
inline constexpr double kFrameEdge = 6;

/// How much larger than usual the letters are, at least 1: marks and pens grow with them.
double markScale(const QFont& font);

/// The marks of pictures, filled with the painter's brush; `size`: across.
void paintMark(QPainter& painter, SeriesMark mark, QPointF centre, double size);

/// From `top` to `bottom` with caps, with the painter's pen.
void paintErrorBar(QPainter& painter, double x, double top, double bottom, double cap);

/// The pen of a curve.
QPen strokeOf(const DiagramSeries& series, const ChartLook& look);

class ChartPanel {
 public:
  explicit ChartPanel(QGraphicsScene& scene);
  ~ChartPanel();
  ChartPanel(const ChartPanel&) = delete;
  ChartPanel& operator=(const ChartPanel&) = delete;

  /// saysAlong: labels and title of the axis along stand below; titleBeside: the title of the other
  /// one stands at the right in this many pixels; 0: upright at the left.
  void show(const Diagram& diagram, const ChartGeometry& geometry, const ChartLook& look,
            bool saysAlong, double titleBeside);

  /// Returns the whole title of the x-axis if it is shown shortened, otherwise an empty text.
  QString cutTitle() const;

 private:
  class UnderItem;
  class OverItem;

  void showAxis(QCategoryAxis& axis, const TickedAxis& ticked, const AxisRange& range);
  void lookAt(QCategoryAxis& axis, const ChartLook& look);
  void showSeries(const Diagram& diagram, const ChartGeometry& geometry, const ChartLook& look);
  void showBand(const DiagramSeries& series, const Diagram& diagram, const ChartLook& look);
  void showRun(const DiagramSeries& series, const QList<QPointF>& run, const ChartLook& look);
  void showMarks(const DiagramSeries& series, const QList<QPointF>& places, double room,
                 const ChartLook& look);
  QScatterSeries& nextMarks();
  QLineSeries& nextLine();
  QAreaSeries& nextBand();
  template <class Series>
  Series* added(Series* series);

  QChart* chart_;  // owned by the scene
  QCategoryAxis *x_, *y_;
  // Owned by the chart; the first ones are in use.
  std::vector<QLineSeries*> lines_;
  std::vector<QScatterSeries*> marks_;
  std::vector<QAreaSeries*> bands_;
  std::size_t linesUsed_ = 0, marksUsed_ = 0, bandsUsed_ = 0;
  UnderItem* under_;
  OverItem* over_;
};

}  // namespace asperity
