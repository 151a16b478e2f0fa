#include "ui/panels/value_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"

namespace asperity {
namespace {

constexpr int kSteps = 1000;
constexpr int kSliderDigits = 3;

struct Span {
  double from, to;
  Scale scale;
  bool whole;
};

Span sliderSpan(const Parameter& parameter) {
  if (const auto* real = std::get_if<RealField>(&parameter.field))
    return {real->sliderFrom, real->sliderTo, real->scale, false};
  const auto& integer = std::get<IntegerField>(parameter.field);
  return {static_cast<double>(integer.sliderFrom), static_cast<double>(integer.sliderTo),
          integer.scale, true};
}

/// Returns the span with a value in it, as far as the parameter allows.
Span extended(Span span, const Parameter& parameter, double value) {
  const bool isLogarithmic = span.scale != Scale::Linear;
  if (!std::isfinite(value) || (isLogarithmic && !(value > 0))) return span;
  const AllowedRange allowed = *allowedRange(parameter);
  const auto decade = [](double exponent) { return roundedToDigits(std::pow(10, exponent), 15); };
  if (value < span.from)
    span.from =
        std::max(isLogarithmic ? decade(std::floor(std::log10(value))) : value, allowed.minimum);
  if (value > span.to)
    span.to =
        std::min(isLogarithmic ? decade(std::ceil(std::log10(value))) : value, allowed.maximum);
  return span;
}

}  // namespace

SliderScale::SliderScale(const Parameter& parameter, std::optional<double> value) {
  Span span = sliderSpan(parameter);
  if (value) span = extended(span, parameter, *value);
  scale_ = span.scale;
  if (scale_ == Scale::LogarithmicFromNone) values_.push_back(0);
  const double low = coordinate(span.from);
  const double high = coordinate(span.to);
  for (int i = 0; i <= kSteps; ++i) {
    const double between = low + (high - low) * i / kSteps;
    double place = scale_ == Scale::Linear ? between : std::exp(between);
    place = roundedToDigits(place, kSliderDigits);
    if (span.whole) place = std::round(place);
    place = std::clamp(place, span.from, span.to);
    if (values_.empty() || place > values_.back()) values_.push_back(place);
  }
}

double SliderScale::coordinate(double value) const {
  return scale_ == Scale::Linear ? value : std::log(value);
}

int SliderScale::largeStep() const {
  const double first = scale_ == Scale::LogarithmicFromNone ? values_[1] : values_.front();
  const double decades = scale_ == Scale::Linear ? 10 : std::log10(values_.back() / first);
  return std::max(1, static_cast<int>(std::lround((count() - 1) / std::max(1.0, decades))));
}

double SliderScale::valueAt(int position) const {
  return values_[static_cast<std::size_t>(std::clamp(position, 0, count() - 1))];
}

int SliderScale::sliderPosition(double value) const {
  const auto above = std::lower_bound(values_.begin(), values_.end(), value);
  if (above == values_.begin()) return 0;
  if (above == values_.end()) return count() - 1;
  const double middle = (coordinate(*(above - 1)) + coordinate(*above)) / 2;
  const auto nearest =
      coordinate(value) < middle ? above - 1 : above;  // NaN is far from all values
  return static_cast<int>(nearest - values_.begin());
}

namespace {

constexpr double kSmallestHandle = 6.5;  // radius, pixels
constexpr double kGroove = 4;
constexpr double kFinely = 0.1;  // of the pointer's distance, with Shift

}  // namespace

ValueSlider::ValueSlider(const SliderScale& scale, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), scale_(scale) {
  setScale(scale);
  setFocusPolicy(Qt::StrongFocus);  // the wheel does not give it the focus
  setAttribute(Qt::WA_Hover);       // it is painted again when the pointer enters or leaves
  connect(this, &QSlider::valueChanged, this,
          [this](int position) { emit valuePicked(scale_.valueAt(position)); });
}

void ValueSlider::setScale(const SliderScale& scale) {
  const QSignalBlocker blocker(this);
  scale_ = scale;
  setRange(0, scale_.count() - 1);
  setSingleStep(std::max(1, scale_.count() / 100));
  setPageStep(scale_.largeStep());
}

void ValueSlider::showValue(double value) {
  if (isSliderDown()) return;  // the user is moving it
  const QSignalBlocker blocker(this);
  setValue(scale_.sliderPosition(value));
}

QSize ValueSlider::sizeHint() const {
  return {110, minimumSizeHint().height()};
}

QSize ValueSlider::minimumSizeHint() const {
  return {40, static_cast<int>(2 * radius()) + 7};  // a smaller one would be a dot
}

double ValueSlider::radius() const {
  return handleRadius(fontMetrics());
}

double ValueSlider::handleX() const {
  const double available = width() - 2 * radius() - 2;
  return radius() + 1 + available * sliderPosition() / std::max(1, maximum());
}

int ValueSlider::positionAt(double x) const {
  const double available = width() - 2 * radius() - 2;
  return QStyle::sliderValueFromPosition(minimum(), maximum(), static_cast<int>(x - radius() - 1),
                                         static_cast<int>(available));
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const QRect handle =
        style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
    fine_.reset();
    if (!handle.contains(event->position().toPoint()))
      setSliderPosition(positionAt(event->position().x()));
  }
  QSlider::mousePressEvent(event);
}

/// With Shift the handle moves from its present position by a part of the pointer's distance;
/// without it the handle is under the pointer again.
void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
  const bool isFine = isSliderDown() && event->modifiers().testFlag(Qt::ShiftModifier);
  if (!isFine) {
    fine_.reset();
    return QSlider::mouseMoveEvent(event);
  }
  const double x = event->position().x();
  if (!fine_) fine_ = {sliderPosition(), x};
  const double perPixel = maximum() / std::max(1.0, width() - 2 * radius() - 2);
  setSliderPosition(fine_->position +
                    static_cast<int>(std::lround(kFinely * (x - fine_->x) * perPixel)));
}

void ValueSlider::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const bool isUp = key == Qt::Key_Right || key == Qt::Key_Up;
  const bool isDown = key == Qt::Key_Left || key == Qt::Key_Down;
  if (event->modifiers().testFlag(Qt::ShiftModifier) && (isUp || isDown))
    return setValue(value() + (isUp ? 1 : -1));
  QSlider::keyPressEvent(event);
}

void ValueSlider::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) return QSlider::wheelEvent(event);
  event->ignore();  // so that the panel scrolls
}

void ValueSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  drawSlider(painter, rect(), handleX(), palette(),
             {isEnabled(), underMouse(), hasFocus(), isSliderDown(), radius()});
}

double handleRadius(const QFontMetrics& letters) {
  return std::max(kSmallestHandle, 0.36 * letters.height());
}

void drawSlider(QPainter& painter, const QRectF& rect, double x, const QPalette& colours,
                const SliderState& state) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const double middle = rect.center().y();
  const double radius = std::min(state.radius, rect.height() / 2 - 1);
  const QColor rim = colours.color(state.isEnabled ? QPalette::Highlight : QPalette::Mid);
  const auto bar = [&](double from, double to, const QColor& colour) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(QRectF(from, middle - kGroove / 2, to - from, kGroove), 2, 2);
  };
  bar(rect.left() + 1, rect.right() - 1, colours.color(QPalette::Mid));
  bar(rect.left() + 1, x, rim);
  if (state.hasFocus) {
    QColor halo = colours.color(QPalette::Highlight);
    halo.setAlphaF(0.25F);
    painter.setBrush(halo);
    painter.drawEllipse(QPointF(x, middle), radius + 3, radius + 3);
  }
  const bool isHighlighted = state.isUnderMouse || state.hasFocus || state.isDown;
  painter.setPen(QPen(rim, isHighlighted ? 2 : 1.5));
  painter.setBrush(colours.color(state.isDown ? QPalette::Highlight : QPalette::Base));
  painter.drawEllipse(QPointF(x, middle), radius - 0.5, radius - 0.5);
  painter.restore();
}

}  // namespace asperity
