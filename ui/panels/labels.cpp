#include "ui/panels/labels.h"

#include <QEvent>
#include <QHelpEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QResizeEvent>
#include <QStyle>
#include <QToolTip>
#include <algorithm>

#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/panel_style.h"

namespace asperity {

QLabel* textLabel(const QString& name) {
  auto* label = named<QLabel>(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

namespace {

/// Makes a label of several lines with a role of the style sheet of messages.
QLabel* roleLabel(const QString& name, const char* role) {
  QLabel* label = textLabel(name);
  label->setProperty("role", role);
  return label;
}

}  // namespace

QLabel* errorTextLabel(const QString& name) {
  return roleLabel(name, "error");
}

void setMessage(QLabel& label, const QString& text, MessageKind kind) {
  setStyleProperty(label, "role", kind == MessageKind::Error ? "error" : "");
  label.setText(text);
}

QLabel* warningTextLabel(const QString& name) {
  return roleLabel(name, "warning");
}

QString warningLines(const QStringList& warnings) {
  QStringList lines;
  for (const QString& warning : warnings) lines += QStringLiteral("⚠ ") + warning;
  return lines.join('\n');
}

void showWarnings(QLabel& label, const QStringList& warnings) {
  label.setText(keptTogether(warningLines(warnings)));
  label.setVisible(!warnings.isEmpty());
}

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

QString ElidedLabel::shownText() const {
  const int available = contentsRect().width();
  // A text cut in the middle may come out wider by the kerning at the cut.
  QString shown;
  for (int width = available; width > 0; --width) {
    shown = fontMetrics().elidedText(text(), Qt::ElideMiddle, width);
    if (fontMetrics().horizontalAdvance(shown) <= available) break;
  }
  return shown;
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

QFont boldFont(QFont font) {
  font.setBold(true);
  return font;
}

namespace {

/// Sets the font of a heading whenever that of the widget changes.
class HeadingFont : public QObject {
 public:
  HeadingFont(QLabel& heading, QWidget& of, double scale)
      : QObject(&heading), heading_(heading), of_(of), scale_(scale) {
    of.installEventFilter(this);
    set();
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::FontChange) set();
    return QObject::eventFilter(watched, event);
  }

 private:
  void set() {
    QFont font = boldFont(of_.font());
    font.setPointSizeF(scale_ * font.pointSizeF());
    heading_.setFont(font);
  }

  QLabel& heading_;
  QWidget& of_;
  double scale_;
};

}  // namespace

void keepHeading(QLabel& heading, QWidget& of, double scale) {
  new HeadingFont(heading, of, scale);
}

int widestText(const QWidget& widget, const QStringList& texts) {
  int widest = 0;
  for (const QString& text : texts)
    widest = std::max(widest, widget.fontMetrics().horizontalAdvance(text));
  return widest + 1;  // a label may round its width up
}

}  // namespace asperity
