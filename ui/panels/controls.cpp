#include "ui/panels/controls.h"

#include <QAction>
#include <QCoreApplication>
#include <QFontDatabase>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPolygonF>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QResizeEvent>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>
#include <QTextDocument>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/language/translated.h"

namespace asperity {

QWidget& orderTabs(QWidget& before, const QLayout& layout) {
  QWidget* last = &before;
  for (int i = 0; i < layout.count(); ++i) {
    const QLayout* inner = layout.itemAt(i)->layout();
    if (QWidget* widget = layout.itemAt(i)->widget()) {
      inner = widget->layout();
      if (widget->focusPolicy() & Qt::TabFocus) {
        QWidget::setTabOrder(last, widget);
        last = widget;
      }
    }
    if (inner) last = &orderTabs(*last, *inner);
  }
  return *last;
}

QScrollArea* scrolled(QWidget* content, Qt::ScrollBarPolicy sideways) {
  auto* area = new QScrollArea;
  area->setWidget(content);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(sideways);
  return area;
}

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

QProgressBar* thinProgress(const QString& name, int width) {
  auto* bar = named<QProgressBar>(name);
  bar->setTextVisible(false);
  bar->setFixedSize(width, 6);
  return bar;
}

QPlainTextEdit* fixedText(const QString& name) {
  auto* text = named<QPlainTextEdit>(name);
  text->setReadOnly(true);
  text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  return text;
}

QAction* checkedEntry(QObject& owner, const QString& name, const QString& text, bool isChecked,
                      std::function<void(bool isChecked)> choose) {
  auto* entry = named<QAction>(name, text, &owner);
  entry->setCheckable(true);
  entry->setChecked(isChecked);
  QObject::connect(entry, &QAction::triggered, entry, std::move(choose));
  return entry;
}

QMessageBox::StandardButton ask(
    QWidget* parent, const Question& question,
    std::initializer_list<std::pair<QMessageBox::StandardButton, QString>> answers,
    QMessageBox::StandardButton usual) {
  QMessageBox box(question.icon, question.title, {}, QMessageBox::NoButton, parent);
  box.setObjectName(question.name);
  box.setTextFormat(Qt::PlainText);
  box.setText(question.text);
  box.setInformativeText(question.explanation);
  for (const auto& [button, text] : answers) box.addButton(button)->setText(text);
  box.setDefaultButton(usual);
  if (!box.button(QMessageBox::Cancel)) box.setEscapeButton(usual);
  return static_cast<QMessageBox::StandardButton>(box.exec());
}

TitleBar::TitleBar(const QString& closeName, QWidget* parent)
    : QWidget(parent), title_(new QLabel), close_(named<QToolButton>(closeName)) {
  setObjectName("dockTitle");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 5, 8, 5);
  row->addWidget(title_, 1);
  row->addWidget(close_);
  close_->setText(QStringLiteral("✕"));
  close_->setFocusPolicy(Qt::NoFocus);
}

void TitleBar::insert(QWidget& control) {
  auto* row = static_cast<QHBoxLayout*>(layout());
  row->setSpacing(10);
  row->insertWidget(1, &control);
}

// ---- Boxes

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
  const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (event->key() == Qt::Key_Escape && toPlainText() != accepted_) return replaceText(accepted_);
  if (isEnter && event->modifiers().testFlag(Qt::ControlModifier)) return commit();
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

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128;
}

QColor errorColour(const QPalette& palette) {
  return isDark(palette) ? QColor(0xff, 0x7b, 0x72) : QColor(0xc6, 0x28, 0x28);
}

QColor warningColour(const QPalette& palette) {
  return isDark(palette) ? QColor(0xe3, 0xb3, 0x41) : QColor(0x8a, 0x5a, 0x00);
}

QString panelStyleSheet(const QPalette& palette) {
  const auto name = [&](QPalette::ColorRole role) { return palette.color(role).name(); };
  return QStringLiteral(R"(
    QScrollArea, #parameterRows { background: %1; }
    QLabel[role="heading"] { font-weight: bold; color: %2; }
    QLabel[role="unit"] { color: %3; }
    #panelBar { background: %1; border-bottom: 1px solid %6; }
    QToolButton[role^="segment"] { border: 1px solid %6; background: transparent; color: %3;
                                   padding: 1px 9px; min-height: 19px; }
    QToolButton[role="segmentLeft"] { border-top-left-radius: 5px;
                                      border-bottom-left-radius: 5px; }
    QToolButton[role="segmentRight"] { border-top-right-radius: 5px; border-left: none;
                                       border-bottom-right-radius: 5px; }
    QToolButton[role^="segment"]:checked { background: %5; color: %2; font-weight: bold; }
    QToolButton[role^="segment"]:hover { color: %2; }
    QToolButton[role^="segment"]:focus { color: %7; }
    QLineEdit { background: %5; border: 1px solid %6; border-radius: 5px;
                padding: 1px 5px; min-height: 19px; }
    QPlainTextEdit { background: %5; border: 1px solid %6; border-radius: 5px;
                     padding: 0px 1px; }
    QLineEdit:focus, QPlainTextEdit:focus { border-color: %7; }
    QLineEdit[refused="true"] { border: 2px solid %4; padding: 0px 4px; }
    QLineEdit:disabled { background: transparent; color: %3; }
    QToolButton[role="browse"] { border: 1px solid %6; border-radius: 5px; background: %5;
                                 color: %2; padding: 1px 7px; min-height: 19px; }
    QToolButton[role="browse"]:hover, QToolButton[role="browse"]:focus { border-color: %7; }
    QToolButton[role="browse"]:disabled { background: transparent; color: %3; }
    QToolButton[role="remove"] { border: 1px solid transparent; border-radius: 5px;
                                 background: transparent; color: %3; }
    QToolButton[role="remove"]:hover { color: %4; }
    QToolButton[role="remove"]:focus { border-color: %7; }
    QToolButton[role="remove"]:disabled { color: transparent; }
    QToolButton[role="reset"] { border: none; background: transparent; color: %3; }
    QToolButton[role="reset"]:hover { color: %7; }
    QToolButton[role="reset"]:disabled { color: transparent; }
  )")
             .arg(name(QPalette::Window), name(QPalette::WindowText),
                  name(QPalette::PlaceholderText), errorColour(palette).name(),
                  name(QPalette::Base), name(QPalette::Mid), name(QPalette::Highlight)) +
         messageStyleSheet(palette);
}

QString messageStyleSheet(const QPalette& palette) {
  return QStringLiteral(R"(
    QLabel[role="error"] { color: %1; padding-bottom: 3px; }
    QLabel[role="note"] { color: %2; }
    QLabel[role="warning"] { color: %3; padding-bottom: 3px; }
  )")
      .arg(errorColour(palette).name(), palette.color(QPalette::Highlight).name(),
           warningColour(palette).name());
}

void setStyleProperty(QWidget& widget, const char* name, const QVariant& value) {
  if (widget.property(name) == value) return;
  widget.setProperty(name, value);
  widget.style()->unpolish(&widget);
  widget.style()->polish(&widget);
}

// ---- Labels

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

namespace {

constexpr int kBelowPointer = 16;  // pixels from a position to a tip there; from QTipLabel

/// Returns the size of a tip, or a little more.
QSize tipSize(const QString& text) {
  constexpr QSize kFrame(28, 20);  // margin, padding and border, and the distance from the position
  QLabel tip(text);
  tip.setFont(QToolTip::font());
  tip.setWordWrap(Qt::mightBeRichText(text));
  return tip.sizeHint() + kFrame;
}

QRect screenAt(const QRect& place) {
  const QScreen* screen = QGuiApplication::screenAt(place.center());
  return screen ? screen->availableGeometry() : place;
}

/// Sends the tips of the children to a place beside the widget.
class TipsBeside : public QObject {
 public:
  explicit TipsBeside(QWidget& widget) : QObject(&widget), widget_(widget) {
    for (QWidget* child : widget.findChildren<QWidget*>()) child->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const auto* child = qobject_cast<QWidget*>(watched);
    if (event->type() != QEvent::ToolTip || isPlaced_ || !child || child->toolTip().isEmpty())
      return QObject::eventFilter(watched, event);
    const QRect place(widget_.mapToGlobal(QPoint()), widget_.size());
    QHelpEvent placed(QEvent::ToolTip, static_cast<QHelpEvent*>(event)->pos(),
                      tipBeside(child->toolTip(), place));
    isPlaced_ = true;
    QCoreApplication::sendEvent(watched, &placed);
    isPlaced_ = false;
    return true;
  }

 private:
  QWidget& widget_;
  bool isPlaced_ = false;
};

}  // namespace

QPoint tipAbove(const QString& text, const QRect& place, int x) {
  const int above = place.top() - tipSize(text).height();
  return above >= screenAt(place).top() ? QPoint(x, above - kBelowPointer) : tipBelow(place, x);
}

QPoint tipBelow(const QRect& place, int x) {
  return {x, place.bottom() - kBelowPointer};
}

QPoint tipBeside(const QString& text, const QRect& place) {
  const int left = place.left() - tipSize(text).width();
  return {left >= screenAt(place).left() ? left : place.right(), place.top() - kBelowPointer};
}

void keepTipsBeside(QWidget& widget) {
  new TipsBeside(widget);
}

void setRowShown(QFormLayout& form, QWidget* field, bool isShown) {
  field->setVisible(isShown);
  if (QWidget* label = form.labelForField(field)) label->setVisible(isShown);
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
