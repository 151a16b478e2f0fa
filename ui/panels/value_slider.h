// A thin horizontal slider over a SliderScale. A press anywhere on the groove moves the handle
// there; with Shift the handle follows the pointer ten times more slowly. Arrow keys make steps of
// a hundredth of the slider, with Shift the smallest ones, PageUp and PageDown decades. The wheel
// works only while the slider has the focus, so that scrolling the panel changes nothing. GUI
// thread.
#pragma once

#include <QRectF>
#include <QSlider>
#include <optional>
#include <vector>

#include "core/scene/parameters.h"

class QFontMetrics;
class QPainter;
class QPalette;

namespace asperity {

class SliderScale {
 public:
  /// Makes the scale of a row with a RealField or an IntegerField. It is longer where a value lies
  /// beyond it: a linear one up to the value, a logarithmic one up to the end of its decade.
  explicit SliderScale(const Parameter& parameter, std::optional<double> value = {});

  /// Returns whether the value lies between the ends.
  bool contains(double value) const { return value >= values_.front() && value <= values_.back(); }

  int count() const { return static_cast<int>(values_.size()); }

  /// Returns the positions of a large step: a decade of a logarithmic scale, a tenth of a linear
  /// one.
  int largeStep() const;
  double valueAt(int position) const;

  /// Returns the position with the nearest value, on the row's own scale.
  int sliderPosition(double value) const;

 private:
  double coordinate(double value) const;

  Scale scale_ = Scale::Linear;
  std::vector<double> values_;
};

class ValueSlider : public QSlider {
  Q_OBJECT

 public:
  explicit ValueSlider(const SliderScale& scale, QWidget* parent = nullptr);

  /// Replaces the scale without emitting valuePicked.
  void setScale(const SliderScale& scale);

  bool contains(double value) const { return scale_.contains(value); }

  /// Moves the handle to the nearest position without emitting valuePicked.
  void showValue(double value);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// Emitted when the user moved the handle.
  void valuePicked(double value);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  double radius() const;
  double handleX() const;
  int positionAt(double x) const;

  SliderScale scale_;
  /// The positions of handle and pointer at the beginning of the fine part of a drag.
  struct Grip {
    int position;
    double x;
  };
  std::optional<Grip> fine_;
};

/// Returns the radius of a handle beside letters of this font, pixels.
double handleRadius(const QFontMetrics& letters);

struct SliderState {
  bool isEnabled = true, isUnderMouse = false, hasFocus = false, isDown = false;
  double radius = 0;  // of the handle, pixels
};

/// Draws a horizontal slider with its handle at x.
void drawSlider(QPainter& painter, const QRectF& rect, double x, const QPalette& colours,
                const SliderState& state);

}  // namespace asperity
