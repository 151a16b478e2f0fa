// A frame that highlights a control, used by the guided tour. It is drawn over the control, takes
// no focus and no mouse events, and follows the control when it moves, is resized, hidden or
// scrolled. GUI thread; a child of the window. Cannot fail: without a control there is no frame.
#pragma once

#include <QPointer>
#include <QWidget>
#include <vector>

namespace asperity {

class HighlightFrame : public QWidget {
 public:
  explicit HighlightFrame(QWidget& window);

  /// Draws the frame around this control of the window and scrolls to it; null: around none.
  void highlight(QWidget* control);
  const QWidget* control() const { return control_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void adjustToControl();
  QRect visiblePart() const;

  QWidget& window_;
  QPointer<QWidget> control_;
  std::vector<QPointer<QWidget>> watched_;  // the control and all widgets around it
};

}  // namespace asperity
