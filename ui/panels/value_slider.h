// A slim horizontal slider over a SliderScale. A press anywhere on the groove takes the handle
// there; the wheel counts only while the slider has the focus, so that scrolling past changes
// nothing. GUI thread.
#pragma once

#include <QSlider>

#include "ui/panels/slider_scale.h"

namespace asperity {

class ValueSlider : public QSlider {
  Q_OBJECT

 public:
  explicit ValueSlider(const SliderScale& scale, QWidget* parent = nullptr);

  /// Moves the handle to the nearest position without saying valuePicked.
  void showValue(double value);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// The person moved the handle.
  void valuePicked(double value);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  double handleX() const;
  int positionAt(double x) const;

  SliderScale scale_;
};

}  // namespace asperity
