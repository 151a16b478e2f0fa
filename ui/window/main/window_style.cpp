#include "ui/window/main/window_style.h"

#include <QPainter>
#include <QSlider>
#include <QStyleOption>
#include <algorithm>

#include "ui/panels/value_slider.h"

namespace asperity {

namespace {

/// Draws the border of an entry. That of Fusion is darker than the window, and so invisible in the
/// dark theme.
void drawEntryFrame(QPainter& painter, const QStyleOption& option) {
  const bool hasFocus = option.state & QStyle::State_HasFocus;
  const QColor colour = option.palette.color(hasFocus ? QPalette::Highlight : QPalette::Mid);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  painter.restore();
}

}  // namespace

WindowStyle::WindowStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void WindowStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const {
  if (element == PE_FrameLineEdit) return drawEntryFrame(*painter, *option);
  if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck)
    return QProxyStyle::drawPrimitive(element, option, painter, widget);
  const bool isEnabled = option->state & State_Enabled, hasFocus = option->state & State_HasFocus;
  const bool isOn = option->state & State_On, isPartly = option->state & State_NoChange;
  const QPalette& colours = option->palette;
  const QColor accent = colours.color(QPalette::Active, QPalette::Highlight);
  const QColor faint = colours.color(isEnabled ? QPalette::PlaceholderText : QPalette::Mid);
  const bool isFilled = isEnabled && (isOn || isPartly);
  const double side = std::min(option->rect.width(), option->rect.height());
  QRectF box(0, 0, side - 1, side - 1);
  box.moveCenter(QRectF(option->rect).center());
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(isFilled || hasFocus ? accent : faint, hasFocus ? 2 : 1.2));
  painter->setBrush(isFilled ? accent : colours.color(QPalette::Base));
  painter->drawRoundedRect(box, 3, 3);
  const QColor ink = isFilled ? colours.color(QPalette::Active, QPalette::HighlightedText) : faint;
  painter->setPen(QPen(ink, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const auto at = [&box](double x, double y) {
    return QPointF(box.x() + x * box.width(), box.y() + y * box.height());
  };
  if (isOn)
    painter->drawPolyline(QPolygonF{at(0.24, 0.52), at(0.43, 0.72), at(0.78, 0.3)});
  else if (isPartly)
    painter->drawLine(at(0.26, 0.5), at(0.74, 0.5));
  painter->restore();
}

/// Lets check boxes, handles of sliders and the buttons that scroll tabs grow with the letters,
/// which are more than twice as high in a presentation.
int WindowStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                             const QWidget* widget) const {
  const int usual = QProxyStyle::pixelMetric(metric, option, widget);
  if (!widget) return usual;
  constexpr double kLetterShare = 0.85;  // side of a check box over the height of letters
  switch (metric) {
    case PM_IndicatorWidth:
    case PM_IndicatorHeight:
      return std::max(usual, static_cast<int>(kLetterShare * widget->fontMetrics().height()));
    case PM_SliderLength:
    case PM_SliderThickness:
    case PM_SliderControlThickness:
      return std::max(usual, static_cast<int>(2 * handleRadius(widget->fontMetrics())) + 2);
    case PM_TabBarScrollButtonWidth:
      return std::max(usual, widget->fontMetrics().height());
    default:
      return usual;
  }
}

/// The handle of a slider is as large as it is drawn; that of Fusion has one size.
QRect WindowStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                                  SubControl part, const QWidget* widget) const {
  const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
  if (control != CC_Slider || part != SC_SliderHandle || !slider ||
      slider->orientation != Qt::Horizontal)
    return QProxyStyle::subControlRect(control, option, part, widget);
  const QRect all = slider->rect;
  const int length = pixelMetric(PM_SliderLength, option, widget);
  const int x = sliderPositionFromValue(slider->minimum, slider->maximum, slider->sliderPosition,
                                        all.width() - length, slider->upsideDown);
  const int height = std::min(length, all.height());
  return {all.x() + x, all.y() + (all.height() - height) / 2, length, height};
}

/// Draws sliders like those of the panel (value_slider.h), and spin boxes like other entries.
void WindowStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                     QPainter* painter, const QWidget* widget) const {
  const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
  if (control == CC_SpinBox) {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    return drawEntryFrame(*painter, *option);
  }
  if (control != CC_Slider || !slider || slider->orientation != Qt::Horizontal ||
      slider->upsideDown || slider->tickPosition != QSlider::NoTicks)
    return QProxyStyle::drawComplexControl(control, option, painter, widget);
  const QStyle::State state = option->state;
  const QPointF handle =
      QRectF(subControlRect(CC_Slider, slider, SC_SliderHandle, widget)).center();
  drawSlider(*painter, option->rect, handle.x(), option->palette,
             {state.testFlag(State_Enabled), state.testFlag(State_MouseOver),
              state.testFlag(State_HasFocus), state.testFlag(State_Sunken),
              handleRadius(option->fontMetrics)});
}

}  // namespace asperity
