#include "ui/panels/boxes.h"

#include <QAbstractItemView>
#include <QChildEvent>
#include <QFontMetricsF>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPolygonF>
#include <QResizeEvent>
#include <QTextDocument>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/panels/controls.h"

namespace asperity {

ChoiceBox::ChoiceBox(QWidget* parent) : QComboBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
}

namespace {

constexpr int kTextLeft = 9, kArrowWidth = 22;  // pixels, left of a text and right of it

/// Returns how large the arrow of a list is: it grows with the letters of a presentation, as far as
/// it fits.
double arrowSize(const QWidget& list) {
  return std::clamp(list.fontMetrics().height() / 17.0, 1.0, 2.0);
}

/// Returns the pixels that the arrow takes at the right end of a list.
int arrowWidth(const QWidget& list) {
  return static_cast<int>(std::round(kArrowWidth * arrowSize(list)));
}

}  // namespace

QSize ChoiceBox::sizeHint() const {
  constexpr int kSpare = 3;  // pixels
  const int around = kTextLeft + arrowWidth(*this) + kSpare;
  const int width = shown_.isEmpty()
                        ? QComboBox::sizeHint().width() + 8 + arrowWidth(*this) - kArrowWidth
                        : fontMetrics().horizontalAdvance(shown_) + around;
  return {width, std::max(24, fontMetrics().height() + 8)};
}

void ChoiceBox::setShownText(const QString& text) {
  if (text == shown_) return;
  shown_ = text;
  updateGeometry();
  update();
}

void ChoiceBox::setSpoken(const QString& name, const QString& description) {
  setAccessibleName(name);
  setAccessibleDescription(description.isEmpty() ? name
                                                 : QStringLiteral("%1. %2").arg(name, description));
  nameList();
}

void ChoiceBox::nameList() {
  isListNamed_ = true;
  // view() would make the list, which takes longer than the box.
  if (auto* list = findChild<QAbstractItemView*>()) list->setAccessibleName(accessibleName());
}

void ChoiceBox::childEvent(QChildEvent* event) {
  QComboBox::childEvent(event);
  if (!isListNamed_) return;
  // A screen reader may ask for the list before it is shown; it is not whole yet when it is added.
  if (event->added()) QMetaObject::invokeMethod(this, &ChoiceBox::nameList, Qt::QueuedConnection);
  if (event->polished()) nameList();
}

void ChoiceBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) return QComboBox::wheelEvent(event);
  event->ignore();
}

void ChoiceBox::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPalette& colours = palette();
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(QPen(colours.color(hasFocus() ? QPalette::Highlight : QPalette::Mid), 1));
  painter.setBrush(isEnabled() ? colours.color(QPalette::Base) : QColor(Qt::transparent));
  painter.drawRoundedRect(frame, 5, 5);

  painter.setPen(colours.color(QPalette::Text));
  const QRect text = rect().adjusted(kTextLeft, 0, -arrowWidth(*this), 0);
  painter.drawText(text, Qt::AlignVCenter | Qt::AlignLeft,
                   fontMetrics().elidedText(shownText(), Qt::ElideRight, text.width()));
  if (!isEnabled()) return;
  const double size = arrowSize(*this);
  drawChevron(painter, {width() - 13.0 * size, height() / 2.0 + 0.5}, Chevron::Down,
              colours.color(QPalette::Text), size);
}

void chooseWord(QComboBox& box, const QString& word) {
  if (const int index = box.findData(word); index >= 0) box.setCurrentIndex(index);
}

QString chosenWord(const QComboBox& box) {
  return box.currentData().toString();
}

void drawChevron(QPainter& painter, const QPointF& centre, Chevron direction, const QColor& colour,
                 double size) {
  QPolygonF line{QPointF(-3.5, -2), QPointF(0, 2), QPointF(3.5, -2)};
  for (QPointF& point : line)
    point = centre + size * (direction == Chevron::Down ? point : point.transposed());
  QPainterPath path;
  path.addPolygon(line);
  painter.setPen(QPen(colour, 1.5 * size, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
}

SpinBox::SpinBox(QWidget* parent) : QSpinBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
}

void SpinBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) return QSpinBox::wheelEvent(event);
  event->ignore();
}

namespace {

constexpr int kMinLines = 4, kMaxLines = 10;

}  // namespace

TextBox::TextBox(QWidget* parent) : QPlainTextEdit(parent) {
  setTabChangesFocus(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &QPlainTextEdit::textChanged, this, &TextBox::fitToText);
}

void TextBox::showText(const QString& text) {
  const bool isTyping = hasFocus() && toPlainText() != accepted_;
  accepted_ = text;
  if (!isTyping) replaceText(text);
}

void TextBox::replaceText(const QString& text) {
  accepted_ = text;
  if (toPlainText() != text) setPlainText(text);
}

/// Returns the height of a line, in pixels; layouts of Qt round it up.
double TextBox::lineHeight() const {
  return std::ceil(QFontMetricsF(font()).lineSpacing());
}

/// Returns the height of the text, in pixels, where no scroll bar takes a part of the width.
double TextBox::textHeight() const {
  QTextDocument text;
  text.setDefaultFont(font());
  text.setPlainText(toPlainText());
  text.setTextWidth(contentsRect().width());
  return text.size().height() - 2 * text.documentMargin();
}

QSize TextBox::sizeHint() const {
  constexpr int kAround = 16;  // pixels, margins and frame
  const double text = std::clamp(textHeight(), kMinLines * lineHeight(), kMaxLines * lineHeight());
  return {120, static_cast<int>(std::ceil(text)) + kAround};
}

/// Sets the height, and whether there is a scroll bar. Qt would also show one while the box is
/// still too low; the lines that it breaks earlier could then keep it there.
void TextBox::fitToText() {
  const bool isScrolled = textHeight() > kMaxLines * lineHeight();
  setVerticalScrollBarPolicy(isScrolled ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
  updateGeometry();
}

/// The fit waits until Qt has placed the scroll bar and broken the lines: a scroll bar that came or
/// went meanwhile would leave the lines as they were.
void TextBox::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  if (event->oldSize().width() != event->size().width())
    QMetaObject::invokeMethod(this, &TextBox::fitToText, Qt::QueuedConnection);
}

void TextBox::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() == QEvent::FontChange) fitToText();
}

void TextBox::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && toPlainText() != accepted_) return replaceText(accepted_);
  if (isReturnKey(*event) && event->modifiers().testFlag(Qt::ControlModifier)) return commit();
  QPlainTextEdit::keyPressEvent(event);
}

void TextBox::focusOutEvent(QFocusEvent* event) {
  QPlainTextEdit::focusOutEvent(event);
  if (event->reason() != Qt::PopupFocusReason) commit();
}

/// Passes on the text as one paragraph, which a scene's description is.
void TextBox::commit() {
  const QString text = toPlainText().simplified();
  if (text == accepted_) return replaceText(text);
  emit textCommitted(text);
}

}  // namespace asperity
