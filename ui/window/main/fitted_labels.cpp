#include "ui/window/main/fitted_labels.h"

#include <QHelpEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QResizeEvent>
#include <QStyle>
#include <QToolTip>
#include <algorithm>

#include "ui/language/explained.h"

namespace asperity {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

QString ElidedLabel::shownText() const {
  const int available = contentsRect().width();
  return fontMetrics().elidedText(text(), Qt::ElideMiddle, available);
}

bool ElidedLabel::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QLabel::event(event);
  const bool isCut = shownText() != text();
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                     isCut ? wrappedTip(text()) : QString(), this);
  return true;
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  style()->drawItemText(&painter, contentsRect(), static_cast<int>(alignment()), palette(),
                        isEnabled(), shownText(), foregroundRole());
}

WrappedLabel::WrappedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

QSize WrappedLabel::sizeHint() const {
  return {0, std::max(0, heightForWidth(width()))};
}

QString WrappedLabel::shownText() const {
  static const QRegularExpression word(QStringLiteral("\\S+"));
  QString shown;
  qsizetype end = 0;
  for (auto words = word.globalMatch(text()); words.hasNext();) {
    const QRegularExpressionMatch each = words.next();
    shown += text().mid(end, each.capturedStart() - end) +
             fontMetrics().elidedText(each.captured(), Qt::ElideRight, contentsRect().width());
    end = each.capturedEnd();
  }
  return shown + text().mid(end);
}

void WrappedLabel::paintEvent(QPaintEvent* event) {
  const QString shown = shownText();
  if (shown == text()) return QLabel::paintEvent(event);
  QPainter painter(this);
  style()->drawItemText(&painter, contentsRect(), static_cast<int>(alignment() | Qt::TextWordWrap),
                        palette(), isEnabled(), shown, foregroundRole());
}

void WrappedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  if (event->oldSize().width() != event->size().width()) updateGeometry();
}

int widestText(const QWidget& widget, const QStringList& texts) {
  int widest = 0;
  for (const QString& text : texts)
    widest = std::max(widest, widget.fontMetrics().horizontalAdvance(text));
  return widest;
}

}  // namespace asperity
