#include "ui/window/lesson/answer_input.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QRadioButton>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/units.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"
#include "ui/window/lesson/lesson_pane.h"
#include "ui/window/lesson/lesson_text.h"

namespace asperity {

// ---- Choices

namespace {

/// Returns the style sheet of choices in the colours of the window: those of the style are black in
/// a dark window. The buttons grow with the letters.
QString choiceStyle(const QPalette& palette, const QFontMetrics& letters) {
  const int size = std::max(11, static_cast<int>(0.7 * letters.height()));
  const int ring = std::max(4, size * 4 / 11);
  const auto name = [&palette](QPalette::ColorRole role) { return palette.color(role).name(); };
  return QStringLiteral(R"(
    QRadioButton::indicator { width: %5px; height: %5px; border: 1px solid %1;
                              border-radius: %6px; background: %2; }
    QRadioButton::indicator:checked { border: %7px solid %3; width: %8px; height: %8px; }
    QRadioButton::indicator:disabled { border-color: %4; }
    QRadioButton::indicator:focus { border-color: %3; })")
      .arg(name(QPalette::PlaceholderText), name(QPalette::Base), name(QPalette::Highlight),
           name(QPalette::Mid))
      .arg(size)
      .arg((size + 1) / 2)
      .arg(ring)
      .arg(size + 2 - 2 * ring);
}

/// A choice. An arrow key chooses the one to which it goes, though none was chosen before.
class ChoiceButton : public QRadioButton {
 protected:
  void keyPressEvent(QKeyEvent* event) override {
    QRadioButton::keyPressEvent(event);
    auto* reached = qobject_cast<QRadioButton*>(window()->focusWidget());
    if (reached && reached != this && reached->group() == group()) reached->setChecked(true);
  }
};

/// A choice whose text may take several lines, as a radio button's own text cannot.
class ChoiceLine : public QWidget {
 public:
  ChoiceLine(QRadioButton* button, const QString& text) {
    auto* line = marginless<QHBoxLayout>(this, 6);
    label_ = new QLabel(text);
    label_->setWordWrap(true);
    label_->setTextFormat(Qt::PlainText);
    label_->installEventFilter(this);
    button_ = button;
    line->addWidget(button, 0, Qt::AlignTop);
    line->addWidget(label_, 1);
    button->setAccessibleName(text);
  }
  QLabel& label() { return *label_; }

 protected:
  /// A click on the text chooses, as one on the button does.
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::MouseButtonRelease && button_->isEnabled() &&
        static_cast<const QMouseEvent*>(event)->button() == Qt::LeftButton) {
      button_->setFocus(Qt::MouseFocusReason);
      button_->click();
    }
    return QWidget::eventFilter(watched, event);
  }

 private:
  QLabel* label_;
  QRadioButton* button_;
};

}  // namespace

ChoiceInput::ChoiceInput(const LessonPrediction& prediction, const LessonAnswer* answer,
                         const GivenAnswer* given)
    : choices_(new QButtonGroup(this)) {
  setStyle();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2, 0, 0, 4);
  column->setSpacing(5);
  for (std::size_t i = 0; i < prediction.choices.size(); ++i) {
    const int number = static_cast<int>(i);
    const bool isRight = answer && number == answer->choice;
    const bool isGiven = given && number == given->choice;
    QString text = lineText(prediction.choices[i].text);
    if (isRight) text += QStringLiteral("\u00A0\u00A0✓");
    if (isGiven && !isRight) text += QStringLiteral("\u00A0\u00A0✗");
    auto* button = new ChoiceButton;
    button->setObjectName(QStringLiteral("lessonChoice:%1").arg(number));
    button->setChecked(isGiven);
    button->setEnabled(!answer);
    auto* line = new ChoiceLine(button, text);
    line->label().setObjectName(QStringLiteral("lessonChoiceText:%1").arg(number));
    // The given answer stays as legible as the right one.
    line->label().setEnabled(!answer || isRight || isGiven);
    choices_->addButton(button, number);
    column->addWidget(line);
    connect(button, &QRadioButton::toggled, this, &AnswerInput::edited);
  }
}

void ChoiceInput::setStyle() {
  const QString style = choiceStyle(palette(), fontMetrics());
  if (style != styleSheet()) setStyleSheet(style);
}

void ChoiceInput::changeEvent(QEvent* event) {
  AnswerInput::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) setStyle();
}

QString ChoiceInput::entry() const {
  return choices_->checkedId() < 0 ? QString() : QString::number(choices_->checkedId());
}

void ChoiceInput::enter(const QString& entry) {
  if (QAbstractButton* button = choices_->button(entry.isEmpty() ? -1 : entry.toInt()))
    button->setChecked(true);
}

std::optional<GivenAnswer> ChoiceInput::answer() const {
  if (choices_->checkedId() < 0) return std::nullopt;
  GivenAnswer given;
  given.choice = choices_->checkedId();
  return given;
}

QWidgetList ChoiceInput::controls() const {
  QWidgetList buttons;
  for (QAbstractButton* button : choices_->buttons()) buttons += button;
  return buttons;
}

// ---- A number

NumberInput::NumberInput(const std::string& unit) : number_(new QLineEdit), unit_(unit) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(2, 0, 0, 4);
  number_->setObjectName("lessonNumber");
  number_->setAccessibleName(LessonPane::tr("your answer"));
  number_->setPlaceholderText(LessonPane::tr("a number"));
  number_->setMaximumWidth(16 * fontMetrics().horizontalAdvance('0'));
  line->addWidget(number_);
  line->addWidget(new QLabel(QString::fromStdString(unit)));
  line->addStretch(1);
  connect(number_, &QLineEdit::textChanged, this, [this](const QString& text) {
    entry_ = withoutGroups(text.trimmed());
    emit readAs(reading(text));
    emit edited();
  });
  connect(number_, &QLineEdit::returnPressed, this, &AnswerInput::returnPressed);
}

QString NumberInput::entry() const {
  return entry_;
}

void NumberInput::enter(const QString& entry) {
  entry_ = entry;
  number_->setText(answer() ? inLanguage(entry) : entry);
}

std::optional<GivenAnswer> NumberInput::answer() const {
  QString text = entry_;
  text.replace(QStringLiteral("−"), QStringLiteral("-"));
  const TypedQuantity typed = typedQuantity(text.toStdString(), {unit_, unit_ == "K", false});
  if (!typed.value) return std::nullopt;
  GivenAnswer given;
  given.number = *typed.value;
  return given;
}

QString NumberInput::refusal() const {
  const QString unit = QString::fromStdString(unit_);
  return unit.isEmpty() ? LessonPane::tr("A number is needed, such as 0.5.")
                        : LessonPane::tr("A number is needed, in %1.").arg(unit);
}

QWidgetList NumberInput::controls() const {
  return {number_};
}

/// Returns how a number is read whose mark people take for a decimal sign or for one between
/// thousands; empty for any other text.
QString NumberInput::reading(const QString& typed) const {
  static const QRegularExpression ambiguous(QStringLiteral(R"([1-9]\d{0,2}([.,]\d{3})+(?!\d))"));
  if (!ambiguous.match(typed).hasMatch() || !answer()) return {};
  static const QRegularExpression digits(QStringLiteral(R"(^[+\-\x{2212}]?[\d.]+)"));
  const QRegularExpressionMatch number = digits.match(entry_);
  const QString value = number.captured().replace(QStringLiteral("−"), QStringLiteral("-"));
  return LessonPane::tr("Your number is read as %1.")
      .arg(shownNumber(value.toDouble()) + entry_.mid(number.capturedEnd()));
}

}  // namespace asperity
