#include "ui/panels/text_box.h"

#include <QKeyEvent>

namespace asperity {

namespace {

constexpr int kLines = 4;

}  // namespace

TextBox::TextBox(QWidget* parent) : QPlainTextEdit(parent) {
  setTabChangesFocus(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
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

QSize TextBox::sizeHint() const {
  return {120, kLines * fontMetrics().lineSpacing() + 12};
}

void TextBox::keyPressEvent(QKeyEvent* event) {
  const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (event->key() == Qt::Key_Escape && toPlainText() != accepted_) return replaceText(accepted_);
  if (isEnter && event->modifiers().testFlag(Qt::ControlModifier)) return commit();
  QPlainTextEdit::keyPressEvent(event);
}

void TextBox::focusOutEvent(QFocusEvent* event) {
  QPlainTextEdit::focusOutEvent(event);
  if (event->reason() != Qt::PopupFocusReason) commit();
}

/// A scene's sentence is one paragraph.
void TextBox::commit() {
  const QString text = toPlainText().simplified();
  if (text == accepted_) return replaceText(text);
  emit textCommitted(text);
}

}  // namespace asperity
