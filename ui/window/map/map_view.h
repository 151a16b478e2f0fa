// A map of friction with its cross, which is dragged: it sets both parameters at once, within the
// map. Above the map is the cut through the cross. Pointing anywhere reads the map there. GUI
// thread; belongs to its parent.
#pragma once

#include <optional>

#include "ui/window/figures/diagram_view.h"

namespace asperity {

class MapView : public DiagramView {
  Q_OBJECT

 public:
  using DiagramView::DiagramView;

  /// Shows the cross here, where the sheet itself has none.
  void setCross(double x, double y);

  QSize minimumSizeHint() const override { return {320, 200}; }

 signals:
  /// Emitted while the cross is dragged, and where the map is clicked.
  void crossMoved(double x, double y);
  /// Emitted with the place under the pointer; left: it is beside the map.
  void pointedAt(double x, double y);
  void left();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  const DiagramFrame* map() const;
  void moveCross(const QPointF& to);

  double x_ = 0, y_ = 0;
  bool hasCross_ = false, isDragged_ = false;
};

}  // namespace asperity
