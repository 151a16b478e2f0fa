// A frame around a control that a text speaks of, as the guided tour does. It is drawn over the
// control without taking its place, its focus or its mouse, and follows it when it moves, is
// resized, hidden or scrolled. GUI thread; a child of the window. Cannot fail: without a control
// there is no frame.
#pragma once

#include <QPointer>
#include <QWidget>
#include <vector>

namespace asperity {

class Halo : public QWidget {
 public:
  explicit Halo(QWidget& window);

  /// Draws the frame around this control of the window and scrolls to it; null: around none.
  void surround(QWidget* control);
  const QWidget* control() const { return control_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void follow();
  QRect visiblePart() const;

  QWidget& window_;
  QPointer<QWidget> control_;
  std::vector<QPointer<QWidget>> watched_;  // the control and all widgets around it
};

}  // namespace asperity
