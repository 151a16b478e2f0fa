// A map of friction with its cross, which is dragged: it sets both parameters at once, within the
// map. Above the map is the cut through the cross. Pointing anywhere reads the map there. GUI
// thread; owned by its parent.
#pragma once

#include "ui/window/figures/diagram_view.h"

class QPainter;

namespace asperity {

class MapView : public DiagramView {
  Q_OBJECT

 public:
  using DiagramView::DiagramView;

  /// Shows the cross here, where the sheet itself has none.
  void setCross(double x, double y);

  /// Shows a text beside the cut, above the colour bar, or in a corner of the map where it does not
  /// fit there; an empty one goes away.
  void setReading(const QString& text);
  QString reading() const { return reading_; }

  /// Returns the place of the reading beside the cut; empty where it does not fit.
  QRectF placeBesideCut() const;

  QSize minimumSizeHint() const override { return {320, 200}; }

 signals:
  /// Emitted while the cross is dragged or moved by the arrow keys, and where the map is clicked.
  void crossMoved(double x, double y);
  /// Emitted with the position under the pointer; left: the pointer is beside the map.
  void pointedAt(double x, double y);
  void left();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  const ChartGeometry* map() const;
  void paintReading(QPainter& painter, const QRectF& frame) const;
  void moveCross(const QPointF& to);

  QString reading_;
  double x_ = 0, y_ = 0;
  bool hasCross_ = false, isDragged_ = false;
};

}  // namespace asperity
