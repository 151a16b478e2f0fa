#include "ui/window/main/window_style.h"

#include <QPainter>
#include <QSlider>
#include <QSpinBox>
#include <QStyleOption>
#include <QToolBar>
#include <QWidget>
#include <algorithm>

#include "ui/panels/value_slider.h"

namespace asperity {

namespace {

constexpr double kControlCorner = 5;  // radius of controls, pixels
constexpr double kFrameCorner = 3;    // of text boxes and lists, whose contents have square corners
constexpr int kBesideButtonText = 12;  // pixels at each side
constexpr int kBesideEntryText = 4;    // pixels at each side, in addition to those of Fusion
constexpr int kMenuSign = 18;          // pixels beside the text of a button that opens a menu

/// Draws the border of a control, and fills it.
void drawBorder(QPainter& painter, const QRect& rect, const QColor& colour, const QBrush& fill,
                double corner) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, 1));
  painter.setBrush(fill);
  painter.drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), corner, corner);
  painter.restore();
}

QColor borderColour(const QStyleOption& option) {
  const bool hasFocus = option.state & QStyle::State_HasFocus;
  return option.palette.color(hasFocus ? QPalette::Highlight : QPalette::Mid);
}

QBrush entryFill(const QStyleOption& option) {
  const bool isEnabled = option.state & QStyle::State_Enabled;
  return isEnabled ? option.palette.brush(QPalette::Base) : QBrush(Qt::NoBrush);
}

/// Draws the area of a button: like an entry, and in another colour while it is pressed or on.
void drawButton(QPainter& painter, const QStyleOption& option) {
  const QPalette& colours = option.palette;
  const bool isEnabled = option.state & QStyle::State_Enabled;
  const bool isDown = option.state & (QStyle::State_Sunken | QStyle::State_On);
  const bool isHovered = isEnabled && option.state & QStyle::State_MouseOver;
  const auto* button = qstyleoption_cast<const QStyleOptionButton*>(&option);
  const bool isDefault = button && button->features & QStyleOptionButton::DefaultButton;
  const bool isFlat = button && button->features & QStyleOptionButton::Flat;
  if (isFlat && !isDown && !isHovered) return;
  const QColor border = isEnabled && (isHovered || isDefault)
                            ? colours.color(QPalette::Active, QPalette::Highlight)
                            : borderColour(option);
  drawBorder(painter, option.rect, border,
             isEnabled && isDown ? colours.brush(QPalette::Mid) : entryFill(option),
             kControlCorner);
}

/// Draws a check box, or a round one, which excludes the others of its group.
void drawCheck(QPainter& painter, const QStyleOption& option, bool isRound) {
  const bool isEnabled = option.state & QStyle::State_Enabled;
  const bool hasFocus = option.state & QStyle::State_HasFocus;
  const bool isOn = option.state & QStyle::State_On,
             isPartly = option.state & QStyle::State_NoChange;
  const QPalette& colours = option.palette;
  const QColor accent = colours.color(QPalette::Active, QPalette::Highlight);
  const QColor faint = colours.color(isEnabled ? QPalette::PlaceholderText : QPalette::Mid);
  const bool isFilled = isEnabled && (isOn || isPartly);
  const double side = std::min(option.rect.width(), option.rect.height());
  QRectF box(0, 0, side - 1, side - 1);
  box.moveCenter(QRectF(option.rect).center());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(isFilled || hasFocus ? accent : faint, hasFocus ? 2 : 1.2));
  painter.setBrush(isFilled ? accent : colours.color(QPalette::Base));
  const double corner = isRound ? side / 2 : 3;
  painter.drawRoundedRect(box, corner, corner);
  const QColor ink = isFilled ? colours.color(QPalette::Active, QPalette::HighlightedText) : faint;
  painter.setPen(QPen(ink, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const auto at = [&box](double x, double y) {
    return QPointF(box.x() + x * box.width(), box.y() + y * box.height());
  };
  if (isOn && isRound) {
    painter.setBrush(ink);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(box.center(), 0.2 * side, 0.2 * side);
  } else if (isOn) {
    painter.drawPolyline(QPolygonF{at(0.24, 0.52), at(0.43, 0.72), at(0.78, 0.3)});
  } else if (isPartly) {
    painter.drawLine(at(0.26, 0.5), at(0.74, 0.5));
  }
  painter.restore();
}

/// Draws a small angle that points up or down.
void drawAngle(QPainter& painter, const QRect& rect, bool isUp, const QColor& colour) {
  const QPointF centre = QRectF(rect).center();
  const double size = std::clamp(rect.height() / 10.0, 0.8, 2.0), tip = isUp ? -1.5 : 1.5;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colour, 1.3 * size, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(QPolygonF{centre + size * QPointF(-3, -tip), centre + size * QPointF(0, tip),
                                 centre + size * QPointF(3, -tip)});
  painter.restore();
}

/// Returns whether an entry is a part of a spin box, which has the border and the margins.
bool isInSpinBox(const QWidget* widget) {
  return widget && qobject_cast<const QAbstractSpinBox*>(widget->parentWidget());
}

/// Returns whether a button outside of a tool bar opens a menu, and shows it by a sign beside its
/// text.
bool hasMenuSign(const QStyleOption* option, const QWidget* widget) {
  const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
  return button && button->features & QStyleOptionToolButton::HasMenu &&
         !(button->features & QStyleOptionToolButton::MenuButtonPopup) &&
         !(widget && qobject_cast<const QToolBar*>(widget->parentWidget()));
}

}  // namespace

WindowStyle::WindowStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void WindowStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const {
  switch (element) {
    case PE_FrameLineEdit:
      return drawBorder(*painter, option->rect, borderColour(*option), Qt::NoBrush, kControlCorner);
    case PE_PanelLineEdit: {
      // Entries in spin boxes and tables have no border; Fusion fills the corners of others, too.
      const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
      if (isInSpinBox(widget)) return;
      if (!frame || frame->lineWidth <= 0) break;
      return drawBorder(*painter, option->rect, borderColour(*option), entryFill(*option),
                        kControlCorner);
    }
    case PE_Frame:
      return drawBorder(*painter, option->rect, borderColour(*option), Qt::NoBrush, kFrameCorner);
    case PE_PanelButtonCommand:
    case PE_PanelButtonBevel:
    case PE_PanelButtonTool:
      return drawButton(*painter, *option);
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
      return drawCheck(*painter, *option, false);
    case PE_IndicatorRadioButton:
      return drawCheck(*painter, *option, true);
    case PE_IndicatorArrowDown:
      if (!hasMenuSign(option, widget)) break;
      return drawAngle(*painter,
                       {widget->width() - kMenuSign - 2, widget->height() / 2 - 6, kMenuSign, 14},
                       false, option->palette.color(QPalette::ButtonText));
    default:
      break;
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
}

/// Draws the headers of tables flat, with a line to their right and below, and the text of a button
/// that opens a menu beside its sign.
void WindowStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const {
  if (element == CE_ToolButtonLabel && hasMenuSign(option, widget)) {
    QStyleOptionToolButton label = *static_cast<const QStyleOptionToolButton*>(option);
    label.rect.adjust(0, 0, -kMenuSign, 0);
    return QProxyStyle::drawControl(element, &label, painter, widget);
  }
  if (element != CE_HeaderSection)
    return QProxyStyle::drawControl(element, option, painter, widget);
  const QRect& rect = option->rect;
  painter->save();
  painter->fillRect(rect, option->palette.brush(QPalette::Window));
  painter->setPen(option->palette.color(QPalette::Mid));
  painter->drawLine(rect.bottomLeft(), rect.bottomRight());
  painter->drawLine(rect.topRight(), rect.bottomRight());
  painter->restore();
}

/// Draws sliders like those of the panel (value_slider.h), and spin boxes like other entries.
void WindowStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                     QPainter* painter, const QWidget* widget) const {
  if (const auto* spin = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
      control == CC_SpinBox && spin) {
    const bool isEnabled = option->state & State_Enabled;
    drawBorder(*painter, option->rect, borderColour(*option), entryFill(*option), kControlCorner);
    for (const bool isUp : {true, false}) {
      const bool canStep = spin->stepEnabled & (isUp ? QAbstractSpinBox::StepUpEnabled
                                                     : QAbstractSpinBox::StepDownEnabled);
      drawAngle(
          *painter,
          proxy()->subControlRect(CC_SpinBox, option, isUp ? SC_SpinBoxUp : SC_SpinBoxDown, widget),
          isUp,
          option->palette.color(isEnabled && canStep ? QPalette::Normal : QPalette::Disabled,
                                QPalette::Text));
    }
    return;
  }
  const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
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
    case PM_ExclusiveIndicatorWidth:
    case PM_ExclusiveIndicatorHeight:
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

/// Buttons of questions have words alone, as all other buttons of dialogs.
int WindowStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                           QStyleHintReturn* returned) const {
  return hint == SH_DialogButtonBox_ButtonsHaveIcons
             ? 0
             : QProxyStyle::styleHint(hint, option, widget, returned);
}

QRect WindowStyle::subElementRect(SubElement element, const QStyleOption* option,
                                  const QWidget* widget) const {
  const QRect usual = QProxyStyle::subElementRect(element, option, widget);
  if (element != SE_LineEditContents || isInSpinBox(widget)) return usual;
  const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
  if (!frame || frame->lineWidth <= 0) return usual;  // an entry in a table has no margins
  return usual.adjusted(kBesideEntryText, 0, -kBesideEntryText, 0);
}

/// The handle of a slider is as large as it is drawn; that of Fusion has one size.
QRect WindowStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option,
                                  SubControl part, const QWidget* widget) const {
  if (control == CC_SpinBox && part == SC_SpinBoxEditField)
    return QProxyStyle::subControlRect(control, option, part, widget)
        .adjusted(kBesideEntryText, 0, 0, 0);
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

QSize WindowStyle::sizeFromContents(ContentsType type, const QStyleOption* option,
                                    const QSize& contents, const QWidget* widget) const {
  QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
  const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
  if (type == CT_PushButton)
    size.setWidth(std::max(size.width(), contents.width() + 2 * kBesideButtonText));
  else if (type == CT_ToolButton && hasMenuSign(option, widget))
    size.rwidth() += kMenuSign;
  else if (type == CT_SpinBox)
    size.rwidth() += kBesideEntryText;
  else if (type == CT_LineEdit && frame && frame->lineWidth > 0)
    size.rwidth() += 2 * kBesideEntryText;
  return size;
}

}  // namespace asperity
