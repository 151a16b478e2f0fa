// A sheet of diagrams that a user can point into: the friction curve, and a motion in time. Shows
// the diagrams one under the other over their common axis, by Qt Charts (chart_panel.h); as many
// from the first on as have room.
// Pointer: the marker is dragged (with Shift at a tenth of the pace); a click takes a point; the
// wheel zooms (over an axis' labels that axis alone), dragging pans, a double click fits. Keys:
// left and right move the marker by a part of a decade (with Shift a tenth of it, with Control to
// the next point), + and - zoom, Home fits. Only a logarithmic axis along is zoomed. GUI thread;
// owned by its parent like any widget. Cannot fail: what has no place is not drawn.
#pragma once

#include <QPointF>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/chart/diagram.h"
#include "ui/chart/chart_geometry.h"
#include "ui/chart/chart_panel.h"

class QGraphicsView;

namespace asperity {

class ChartLegend;
class MarkerItem;
class TipItem;

class ChartView : public QWidget {
  Q_OBJECT

 public:
  explicit ChartView(QWidget* parent = nullptr);
  ~ChartView() override;

  /// In English; shown in the language in use.
  void setSheet(const DiagramSheet& sheet);
  /// As it is shown, in the language in use.
  const DiagramSheet& sheet() const { return sheet_; }
  /// The marker of the first diagram alone, which costs little.
  void setMarker(const std::optional<DiagramMarker>& marker);
  void setTheme(const Theme& theme);

  /// Where a value of a diagram is in the widget's pixels; it has to have a place on its axes.
  QPointF positionOf(double x, double y, std::size_t diagram = 0) const;

  /// What is shown: the axes as the sheet has them unless zoomed.
  VisibleRange visibleRange() const;
  bool isZoomed() const { return zoom_.has_value(); }
  void zoom(double factor);  // about the middle; below 1: nearer
  void fit();
  /// Shows this part; none: all, as fit().
  void setZoom(const std::optional<VisibleRange>& window);

  /// The reading of a point: its series' id and its row. May be empty.
  using Describe = std::function<QString(int id, int row)>;
  void setDescribe(Describe describe) { describe_ = std::move(describe); }

  /// What is read at the pointer now; empty where nothing is.
  QString reading() const;

 signals:
  /// The marker is to stand at x, once for each step of a drag and each key. finely: all digits of
  /// it are meant.
  void markerMoved(double x, bool finely);
  void pointChosen(int id, int row);
  void unpinWanted(int id);
  void zoomChanged(bool isZoomed);

 protected:
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
  VisibleRange whole() const;
  void showAll();
  void placeFrames();
  double besideWidth() const;
  void showFocus(bool shows);
  void updateMarker();
  QPointF corner() const;

  void pan(QPointF by);
  void read(QPointF place);
  QString textOf(const ChartTarget& target, QPointF place) const;
  void gripMarker(QPointF place, bool finely);
  void dragMarker(QPointF place, bool finely);
  void moveMarker(double x, bool finely);
  void chooseNextPoint(bool forward);

  DiagramSheet english_, sheet_;  // sheet_ in the language in use
  ChartLook look_;
  Describe describe_;
  bool isDue_ = false;  // what is on the screen is of another sheet
  std::optional<VisibleRange> zoom_;
  ChartLegend* legend_;
  QGraphicsView* view_;
  std::vector<std::unique_ptr<ChartPanel>> panels_;
  std::vector<ChartGeometry> frames_;  // of the diagrams that have room
  MarkerItem* marker_;
  TipItem* tip_;

  enum class Gesture { None, Press, Marker, Pan };
  Gesture gesture_ = Gesture::None;
  ChartTarget pressed_;  // what lay under the pointer
  QPointF pressedAt_, panAt_;
  std::optional<QPointF> hover_;  // where the pointer is, over the chart
  QPointF gripAt_;                // where the pointer took the marker, and
  double grippedX_ = 0;           // where that was then, pixels
  bool gripsFinely_ = false;
  std::optional<AxisRange> held_;  // axis along, while the marker is dragged on it
  double wantedX_;  // of the marker while it is moved, until it is there; NaN: not moved
};

}  // namespace asperity
