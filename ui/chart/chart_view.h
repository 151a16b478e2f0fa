// An interactive sheet of diagrams: the friction curve, or a motion over time. It shows the
// diagrams below each other over their common x-axis, with Qt Charts (chart_panel.h); diagrams that
// do not fit are left out, the last ones first. Pointer: the marker can be dragged (with Shift at a
// tenth of the speed); a click chooses a point; the wheel zooms (over an axis' labels only that
// axis), dragging pans, a double click fits. Keys: left and right move the marker by a part of a
// decade (with Shift a tenth of it, with Control to the next point), + and - zoom, Home fits. Only
// a logarithmic x-axis is zoomed. GUI thread; owned by its parent like any widget. Cannot fail:
// values that the axes cannot show are not drawn.
#pragma once

#include <QPointF>
#include <QWidget>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/chart/diagram.h"
#include "ui/chart/chart_geometry.h"
#include "ui/chart/chart_layout.h"
#include "ui/chart/chart_reading.h"
#include "ui/chart/chart_style.h"
#include "ui/chart/occupancy_grid.h"

class QGraphicsView;
class QHBoxLayout;

namespace asperity {

class ChartLegend;
class ChartPanel;
class MarkerItem;
class TipItem;

class ChartView : public QWidget {
  Q_OBJECT

 public:
  explicit ChartView(QWidget* parent = nullptr);
  ~ChartView() override;

  /// Sets the sheet with English texts; it is shown in the current language.
  void setSheet(const DiagramSheet& sheet);
  /// Returns the sheet as it is shown, in the current language.
  const DiagramSheet& sheet() const { return sheet_; }
  /// Changes only the marker of the first diagram, which is fast.
  void setMarker(const std::optional<DiagramMarker>& marker);
  /// Returns the value on the axis at which the line of the marker stands; NaN without one.
  double lineValue() const;
  /// Moves the line back to its marker, if it waits at the position to which the user moved it.
  void releaseMarker();
  void setTheme(const Theme& theme);

  /// Returns the position of a value in the widget's pixels; the axes must be able to show it.
  QPointF mapToPosition(double x, double y, std::size_t diagram = 0) const;

  /// Returns the frame of the first diagram in the widget's pixels; none before it is laid out.
  std::optional<ChartGeometry> frame() const;

  /// Returns what curves, names and the marker with its label cover in the frame of the first
  /// diagram, in the widget's pixels.
  OccupancyGrid covered() const;

  /// Returns the visible range: the axes of the sheet unless zoomed.
  VisibleRange visibleRange() const;
  bool isZoomed() const { return zoom_.has_value(); }
  void zoom(double factor);  // about the middle; a factor below 1 enlarges
  void fit();
  /// Shows this range; none: everything, as fit().
  void setZoom(const std::optional<VisibleRange>& range);

  /// Sets what reads a point.
  void setDescribe(DescribePoint describe) { describe_ = std::move(describe); }

  /// Replaces the titles of the axes by widgets in which the user chooses what the axes show: one
  /// below the horizontal axis, one above the vertical axis of the first diagram. The view owns
  /// them.
  void setChoosers(QWidget* x, QWidget* y);

  /// Returns where the guide explains what the pointer is or was at last: a legend entry, a region,
  /// the axes; never empty.
  QString guideAnchor() const;

  /// Returns the reading at the pointer; empty where there is none.
  QString reading() const;

 signals:
  /// Emitted at each step of a drag and each key, with the requested position of the marker.
  /// finely: all digits of x are intended.
  void markerMoved(double x, bool finely);
  void pointChosen(int id, int row);
  void unpinRequested(int id);
  /// Emitted by a double click and the Home key, after everything is shown.
  void fitRequested();
  /// Emitted with the titles of the axes and their units, which the choosers show.
  void titlesChanged(const QString& x, const QString& y);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool hasMarker() const;
  std::pair<double, double> markerPosition() const;
  VisibleRange whole() const;
  void showAll();
  void showFocus(bool shows);
  void showLegend();
  void updateMarker();
  QPointF corner() const;

  void pan(QPointF by);
  void read(QPointF position);
  void gripMarker(QPointF position, bool finely);
  void dragMarker(QPointF position, bool finely);
  void moveMarker(double x, bool finely);
  void chooseNextPoint(bool forward);

  DiagramSheet english_, sheet_;  // sheet_ has texts in the current language
  ChartStyle style_;
  DescribePoint describe_;
  bool isDue_ = false;  // the screen shows an earlier sheet
  std::optional<VisibleRange> zoom_;
  QHBoxLayout *head_, *foot_;  // with the choosers
  bool hasChoosers_ = false;   // which show the titles of the axes
  QString xTitle_, yTitle_;
  QString anchor_;  // of the guide, for the object under the pointer; empty: for none
  ChartLegend* legend_;
  QGraphicsView* view_;
  std::vector<std::unique_ptr<ChartPanel>> panels_;
  ChartLayout layout_;
  MarkerItem* marker_;
  TipItem* tip_;

  enum class Gesture { None, Press, Marker, Pan };
  Gesture gesture_ = Gesture::None;
  // Under the pointer when the button was pressed: the marker, or a point by its series' id and its
  // row. Its place in the sheet may change before the button is released.
  bool pressesMarker_ = false;
  std::optional<std::pair<int, int>> pressedPoint_;
  QPointF pressedAt_, panAt_;
  std::optional<QPointF> hover_;  // position of the pointer over the chart
  QPointF gripAt_;                // position at which the pointer gripped the marker
  double grippedX_ = 0;           // pixels, position of the marker at that time
  bool gripsFinely_ = false;
  std::optional<AxisRange> held_;  // x-axis, fixed while the marker is dragged
  double targetX_;                 // target of the marker until it arrives; NaN: not moving
};

}  // namespace asperity
