#include "ui/panels/value_entry.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QToolTip>

#include "core/base/number_text.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"
#include "ui/panels/panel_style.h"

namespace asperity {

ValueEntry::ValueEntry(QWidget* parent) : QLineEdit(parent) {
  connect(this, &QLineEdit::editingFinished, this, [this] { commit(); });
  connect(this, &QLineEdit::textEdited, this, [this] { correctText(); });
}

void ValueEntry::showText(const QString& text, const QString& unit) {
  accepted_ = text;
  acceptedUnit_ = unit;
  if (hasError() || (hasFocus() && isModified())) return;
  replaceText(text, unit);
}

void ValueEntry::replaceText(const QString& text, const QString& unit) {
  accepted_ = text;
  acceptedUnit_ = unit;
  showError({});
  showUnit(unit);
  if (this->text() != text) {
    setText(text);
    if (shownEnd_ == Qt::LeftEdge)
      home(false);
    else
      end(false);
  }
  setModified(false);
}

void ValueEntry::showUnit(const QString& unit) {
  if (unit_ == unit) return;
  unit_ = unit;
  speakName();
  emit unitShown(unit);
}

void ValueEntry::setSpokenName(const QString& name) {
  spokenName_ = name;
  speakName();
}

/// The number alone would be read in another unit: 200 mN as 200 N.
void ValueEntry::speakName() {
  setAccessibleName(unit_.isEmpty() ? spokenName_
                                    : QStringLiteral("%1 (%2)").arg(spokenName_, unit_));
}

void ValueEntry::changeEvent(QEvent* event) {
  QLineEdit::changeEvent(event);
  const bool isRefused = hasError() && (text() != accepted_ || unit_ != acceptedUnit_);
  if (event->type() == QEvent::LanguageChange && isRefused) emit textCommitted(text());
}

void ValueEntry::showError(const QString& reason) {
  if (reason == reason_) return;
  reason_ = reason;
  setStyleProperty(*this, "refused", hasError());
}

/// Returns whether the entry handles the key itself: undo and redo only for input that has not been
/// accepted yet.
bool ValueEntry::handlesKey(const QKeyEvent& event) const {
  if (event.matches(QKeySequence::Undo)) return text() != accepted_ && isUndoAvailable();
  if (event.matches(QKeySequence::Redo)) return isRedoAvailable();
  return true;
}

/// A line edit claims the keys of undo and redo even if it has nothing to undo.
bool ValueEntry::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && !handlesKey(*static_cast<QKeyEvent*>(event))) {
    event->ignore();
    return false;
  }
  if (const QString shown = shownText(); event->type() == QEvent::ToolTip && shown != text()) {
    const QString whole = QStringLiteral("<p>%1</p>").arg((text() + ' ' + unit_).toHtmlEscaped());
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), whole + toolTip(), this);
    return true;
  }
  return QLineEdit::event(event);
}

/// Returns where the text is drawn, inside of the frame and of Qt's own margin of 2 pixels.
QRect ValueEntry::textRect() const {
  QStyleOptionFrame option;
  initStyleOption(&option);
  return style()
      ->subElementRect(QStyle::SE_LineEditContents, &option, this)
      .marginsRemoved(textMargins())
      .adjusted(2, 0, -2, 0);
}

QString ValueEntry::shownText() const {
  constexpr int kMostDigits = 6;  // significant ones of a rounded number
  const int width = textRect().width();
  const auto fits = [&](const QString& shown) {
    return fontMetrics().horizontalAdvance(shown) <= width;
  };
  if (hasFocus() || hasError() || isModified() || fits(text())) return text();
  bool isNumber = false;
  const double value = withPoint(text()).toDouble(&isNumber);
  if (!isNumber)
    return fontMetrics().elidedText(
        text(), shownEnd_ == Qt::LeftEdge ? Qt::ElideRight : Qt::ElideLeft, width);
  for (int digits = kMostDigits; digits > 1; --digits)
    if (const QString shown = shownNumber(roundedToDigits(value, digits)); fits(shown))
      return shown;
  return text();
}

void ValueEntry::paintEvent(QPaintEvent* event) {
  const QString shown = shownText();
  if (shown == text()) return QLineEdit::paintEvent(event);
  QStyleOptionFrame option;
  initStyleOption(&option);
  QPainter painter(this);
  style()->drawPrimitive(QStyle::PE_PanelLineEdit, &option, &painter, this);
  style()->drawItemText(&painter, textRect(), static_cast<int>(alignment() | Qt::AlignVCenter),
                        palette(), isEnabled(), shown, QPalette::Text);
}

void ValueEntry::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && (hasError() || isModified())) {
    replaceText(accepted_, acceptedUnit_);
    selectAll();
    emit entryRestored();
    return;
  }
  const int key = event->key();
  if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp ||
      key == Qt::Key_PageDown) {
    commit();
    if (!hasError()) emit stepped(key, event->modifiers());
    return;
  }
  QLineEdit::keyPressEvent(event);
  if (isReturnKey(*event) && !hasError()) clearFocus();
}

/// Removes the error where the text is again that of the accepted value.
void ValueEntry::correctText() {
  if (!hasError() || text() != accepted_ || unit_ != acceptedUnit_) return;
  setModified(false);
  showError({});
  emit entryRestored();
}

void ValueEntry::commit() {
  if (!isModified()) return;
  setModified(false);
  if (text() == accepted_) return showError({});
  emit textCommitted(text());
}

}  // namespace asperity
