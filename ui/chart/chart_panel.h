// One diagram of the interactive chart. Qt Charts draws its axes with their labels and its series:
// curves (QLineSeries), marks (QScatterSeries) and bands (QAreaSeries), whose points are replaced
// when the diagram changes. What Qt Charts cannot do is painted here, in two items under and over
// the series, for these reasons:
// - ticks: its logarithmic axis has none between decades, and cannot have our labels. Therefore the
//   axes hold decimal logarithms (or plain values) under the labels that every picture has.
// - the grid: a QCategoryAxis has no lines between its labels, and lines between pixels are faint.
// - regions: it shades whole intervals between labels, and does not name them.
// - error bars: its lines do not break, so that each bar would need a series of its own.
// - titles: they are cut even where there is enough space.
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

/// The appearance of a chart: the colours of its theme and its font; marks and pens grow with the
/// font.
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
  QColor span() const;      // of every second region
  QColor shade() const;     // a translucent tint
  QColor marker() const;
  QColor of(const DiagramSeries& series) const;
  double scale() const;  // at least 1
  double line() const;   // pixels, height of a line of text
};

/// Opacity of objects that belong to an earlier state.
inline constexpr double kFadedOpacity = 0.3;

/// Length in pixels, times the scale, by which a frame extends beyond the ends of its x-axis, so
/// that marks there are complete.
inline constexpr double kFrameEdge = 6;

/// Returns the size of the font relative to the usual one, at least 1; marks and pens grow with it.
double markScale(const QFont& font);

/// Paints a mark as in pictures, filled with the painter's brush. `size`: its width.
void paintMark(QPainter& painter, SeriesMark mark, QPointF centre, double size);

/// Paints an error bar from `top` to `bottom` with caps, with the painter's pen.
void paintErrorBar(QPainter& painter, double x, double top, double bottom, double cap);

/// Returns the pen of a curve.
QPen strokeOf(const DiagramSeries& series, const ChartLook& look);

class ChartPanel {
 public:
  explicit ChartPanel(QGraphicsScene& scene);
  ~ChartPanel();
  ChartPanel(const ChartPanel&) = delete;
  ChartPanel& operator=(const ChartPanel&) = delete;

  /// hasXLabels: labels and title of the x-axis are drawn below. titleBeside: the title of the
  /// y-axis is on the right and this many pixels wide; 0: it is upright on the left, or level above
  /// the frame (titleAbove). `isTitled`: whether the panel draws the titles itself.
  struct Titled {
    bool x = true, y = true;
  };
  void show(const Diagram& diagram, const ChartGeometry& geometry, const ChartLook& look,
            bool hasXLabels, double titleBeside, bool titleAbove, Titled isTitled);

  /// Returns the titles with their units as they fit the visible range.
  const QString& xTitle() const { return xTitle_; }
  const QString& yTitle() const { return yTitle_; }

  /// Returns the places of the names of shades, which are inside the frame.
  QList<QRectF> namesInside() const;

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

  QChart* chart_;  // owned by the graphics scene
  QCategoryAxis *x_, *y_;
  // The chart owns these; the first ones of each list are in use.
  std::vector<QLineSeries*> lines_;
  std::vector<QScatterSeries*> marks_;
  std::vector<QAreaSeries*> bands_;
  std::size_t linesUsed_ = 0, marksUsed_ = 0, bandsUsed_ = 0;
  QString xTitle_, yTitle_;
  UnderItem* under_;
  OverItem* over_;
};

}  // namespace asperity
