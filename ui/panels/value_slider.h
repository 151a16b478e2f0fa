// A thin horizontal slider over a SliderScale. A press anywhere on the groove moves the handle
// there; the wheel works only while the slider has the focus, so that scrolling the panel changes
// nothing. GUI thread.
#pragma once

#include <QSlider>
#include <vector>

#include "core/scene/parameters.h"

namespace asperity {

class SliderScale {
 public:
  /// Makes the scale of a row with a RealField or an IntegerField.
  explicit SliderScale(const Parameter& parameter);

  int count() const { return static_cast<int>(values_.size()); }
  double valueAt(int position) const;

  /// Returns the position with the nearest value, on the row's own scale.
  int positionOf(double value) const;

 private:
  double coordinate(double value) const;

  Scale scale_ = Scale::Linear;
  std::vector<double> values_;
};

class ValueSlider : public QSlider {
  Q_OBJECT

 public:
  explicit ValueSlider(const SliderScale& scale, QWidget* parent = nullptr);

  /// Moves the handle to the nearest position without emitting valuePicked.
  void showValue(double value);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// Emitted when the user moved the handle.
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
