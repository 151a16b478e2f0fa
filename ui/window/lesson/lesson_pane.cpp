#include "ui/window/lesson/lesson_pane.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTextDocumentFragment>
#include <QTimer>
#include <QVBoxLayout>

#include "core/base/units.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/number_text.h"
#include "ui/window/lesson/lesson_text.h"

namespace asperity {

namespace {

constexpr int kNoteMargin = 4;  // pixels below a note that is scrolled to

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

/// A button that is no wider than its text needs, so that three of them fit beside each other.
class FootButton : public QPushButton {
 public:
  QSize sizeHint() const override {
    constexpr int kAround = 24;  // pixels beside the text
    return {fontMetrics().horizontalAdvance(text()) + kAround, QPushButton::sizeHint().height()};
  }
  QSize minimumSizeHint() const override { return sizeHint(); }
};

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
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(6);
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
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::MouseButtonRelease && button_->isEnabled()) {
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

LessonPane::LessonPane(QWidget* parent) : QWidget(parent), scroll_(new QScrollArea) {
  setObjectName("lessonPane");
  auto* content = new QWidget;
  content->setObjectName("lessonContent");
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(14, 8, 14, 8);
  column->setSpacing(6);
  title_ = addText(*column, "lessonStepTitle");
  text_ = addText(*column, "lessonText");
  question_ = addText(*column, "lessonQuestion");
  tolerance_ = addText(*column, "lessonTolerance");
  inputLayout_ = new QVBoxLayout;
  column->addLayout(inputLayout_);
  verdict_ = addText(*column, "lessonVerdict");
  reveal_ = addText(*column, "lessonReveal");
  note_ = addText(*column, "lessonNote");
  column->addStretch(1);
  setHeading();
  QFont strong = question_->font();
  strong.setBold(true);
  question_->setFont(strong);

  scroll_->setWidget(content);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);  // its texts take the focus
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

  progress_ = new QLabel;
  progress_->setObjectName("lessonProgress");
  const auto button = [](const char* name) {
    auto* made = new FootButton;
    made->setObjectName(name);
    made->setAutoDefault(false);
    return made;
  };
  back_ = button("lessonBack");
  show_ = button("lessonShow");
  next_ = button("lessonNext");
  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(14, 6, 14, 8);
  foot->setSpacing(6);
  foot->addWidget(progress_, 1);
  for (QPushButton* one : {back_, show_, next_}) foot->addWidget(one);
  QSizePolicy kept = show_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  show_->setSizePolicy(kept);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(0);
  all->addWidget(scroll_, 1);
  all->addLayout(foot);

  // Texts get their heights one after the other, and others with the width of the window.
  connect(scroll_->verticalScrollBar(), &QScrollBar::rangeChanged, this, [this] {
    if (!isScrolledByHand_) scroll();
  });
  connect(scroll_->verticalScrollBar(), &QScrollBar::actionTriggered, this,
          [this] { isScrolledByHand_ = true; });
  connect(back_, &QPushButton::clicked, this, &LessonPane::backRequested);
  connect(show_, &QPushButton::clicked, this, &LessonPane::solutionRequested);
  connect(next_, &QPushButton::clicked, this, [this] {
    if (isAsking_)
      check();
    else
      emit nextRequested();
  });
  keepTranslated(*this, [this] {
    back_->setText(tr("Back"));
    show_->setText(tr("Show me"));
    show_->setToolTip(tr("Shows the answer without a guess"));
    showButtons();
  });
}

QLabel* LessonPane::addText(QVBoxLayout& column, const char* name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::RichText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label->setFocusPolicy(Qt::TabFocus);
  column.addWidget(label);
  return label;
}

void LessonPane::showStep(const LessonPage& page) {
  const LessonStep& step = page.lesson->steps[static_cast<std::size_t>(page.step)];
  const auto fill = [](QLabel& label, const QString& html) {
    label.setText(html);
    label.setVisible(!html.isEmpty());
  };
  const int count = static_cast<int>(page.lesson->steps.size());
  isFirst_ = page.step == 0;
  isLast_ = page.step + 1 == count;
  isWaiting_ = false;
  isPointPlaced_ = false;
  unit_ = page.unit;
  progress_->setText(tr("%1 of %2").arg(page.step + 1).arg(count));
  fill(*title_, lineText(step.title).toHtmlEscaped());
  fill(*text_, richText(shown(step.text)) + (step.prediction ? QString() : page.remark));
  fill(*note_, {});
  clearInput();
  isAsking_ = step.prediction && !page.answer;
  kind_.reset();
  if (step.prediction) kind_ = step.prediction->kind;
  fill(*question_,
       step.prediction ? lineText(step.prediction->question).toHtmlEscaped() : QString());
  fill(*tolerance_, step.prediction ? pointTolerance(*step.prediction).toHtmlEscaped() : QString());
  if (step.prediction && step.prediction->kind == PredictionKind::Choice)
    addChoices(*step.prediction, page);
  if (isAsking_ && step.prediction->kind == PredictionKind::Number) addNumber(page);
  QString verdict, reveal;
  if (step.prediction && page.answer) {
    verdict = verdictText(*step.prediction, *page.answer, *page.given, page.isRight);
    reveal = richText(step.reveal, *step.prediction, *page.answer, *page.given) + page.remark;
  }
  fill(*verdict_, verdict);
  // The focus moves to the button; its description gives the right answer to screen readers.
  next_->setAccessibleDescription(QTextDocumentFragment::fromHtml(verdict + reveal).toPlainText());
  fill(*reveal_, reveal);
  showButtons();
  isRevealed_ = page.answer != nullptr;
  isScrolledByHand_ = false;
  QTimer::singleShot(0, this, &LessonPane::scroll);
}

/// Sets the font of the step's title from that of the window.
void LessonPane::setHeading() {
  QFont heading = font();
  heading.setBold(true);
  heading.setPointSizeF(heading.pointSizeF() * 1.12);
  title_->setFont(heading);
}

void LessonPane::scroll() {
  scrollToStep();
  scrollToNote();
}

/// Scrolls to the beginning of a step. With an answer it scrolls to the end; where the question
/// would then be out of sight, to the question, or to the verdict if the verdict would not be
/// visible.
void LessonPane::scrollToStep() {
  QScrollBar& bar = *scroll_->verticalScrollBar();
  if (!isRevealed_) return bar.setValue(0);
  const int end = bar.maximum();
  const auto isInView = [&](const QWidget& part, int from) {
    return part.geometry().bottom() <= from + scroll_->viewport()->height();
  };
  int from = end;
  if (question_->isVisible() && question_->y() < end) from = question_->y();
  if (verdict_->isVisible() && !isInView(*verdict_, from)) from = std::min(verdict_->y(), end);
  bar.setValue(from);
}

void LessonPane::clearInput() {
  choices_ = nullptr;
  number_ = nullptr;
  if (!input_) return;
  inputLayout_->removeWidget(input_);
  input_->setParent(nullptr);
  input_->deleteLater();
  input_ = nullptr;
}

/// Adds the choices; once the answer is known, the right one and a wrong given one are marked.
void LessonPane::addChoices(const LessonPrediction& prediction, const LessonPage& page) {
  input_ = new QWidget;
  input_->setStyleSheet(choiceStyle(palette(), fontMetrics()));
  auto* column = new QVBoxLayout(input_);
  column->setContentsMargins(2, 0, 0, 4);
  column->setSpacing(5);
  choices_ = new QButtonGroup(input_);
  for (std::size_t i = 0; i < prediction.choices.size(); ++i) {
    const int number = static_cast<int>(i);
    auto* button = new ChoiceButton;
    button->setObjectName(QStringLiteral("lessonChoice:%1").arg(number));
    QString text = lineText(prediction.choices[i].text);
    if (page.answer) {
      const bool isRight = number == page.answer->choice;
      const bool isGiven = number == page.given->choice;
      if (isRight) text += QStringLiteral("\u00A0\u00A0✓");
      if (isGiven && !isRight) text += QStringLiteral("\u00A0\u00A0✗");
      button->setChecked(isGiven);
      button->setEnabled(false);
    }
    auto* line = new ChoiceLine(button, text);
    line->label().setObjectName(QStringLiteral("lessonChoiceText:%1").arg(number));
    // The given answer stays as legible as the right one.
    line->label().setEnabled(!page.answer || number == page.answer->choice ||
                             (page.given && number == page.given->choice));
    choices_->addButton(button, number);
    column->addWidget(line);
    connect(button, &QRadioButton::toggled, this, &LessonPane::showButtons);
  }
  inputLayout_->addWidget(input_);
  QWidget* before = question_;
  for (QAbstractButton* button : choices_->buttons()) {
    setTabOrder(before, button);
    before = button;
  }
}

void LessonPane::addNumber(const LessonPage& page) {
  input_ = new QWidget;
  auto* line = new QHBoxLayout(input_);
  line->setContentsMargins(2, 0, 0, 4);
  number_ = new QLineEdit;
  number_->setObjectName("lessonNumber");
  number_->setAccessibleName(tr("your answer"));
  number_->setPlaceholderText(tr("a number"));
  number_->setMaximumWidth(16 * fontMetrics().horizontalAdvance('0'));
  line->addWidget(number_);
  line->addWidget(new QLabel(QString::fromStdString(page.unit)));
  line->addStretch(1);
  connect(number_, &QLineEdit::textChanged, this, [this](const QString& text) {
    showNote(readingText(text));
    showButtons();
  });
  connect(number_, &QLineEdit::returnPressed, this, [this] {
    if (next_->isEnabled()) next_->click();
  });
  inputLayout_->addWidget(input_);
  setTabOrder(question_, number_);
}

/// Returns how a number is read whose mark people take for a decimal sign or for one between
/// thousands; empty for any other text.
QString LessonPane::readingText(const QString& typed) const {
  static const QRegularExpression ambiguous(QStringLiteral(R"([1-9]\d{0,2}([.,]\d{3})+(?!\d))"));
  if (!ambiguous.match(typed).hasMatch() || !typedAnswer()) return {};
  static const QRegularExpression digits(QStringLiteral(R"(^[+\-\x{2212}]?[\d.]+)"));
  const QString text = withoutGroups(typed.trimmed());
  const QRegularExpressionMatch number = digits.match(text);
  const QString value = number.captured().replace(QStringLiteral("−"), QStringLiteral("-"));
  return tr("Your number is read as %1.")
      .arg(shownNumber(value.toDouble()) + text.mid(number.capturedEnd()));
}

/// Returns the answer that was chosen or typed; nothing where it cannot be read.
std::optional<GivenAnswer> LessonPane::typedAnswer() const {
  GivenAnswer given;
  if (choices_) {
    if (choices_->checkedId() < 0) return std::nullopt;
    given.choice = choices_->checkedId();
  } else if (number_) {
    QString text = withoutGroups(number_->text().trimmed());
    text.replace(QStringLiteral("−"), QStringLiteral("-"));
    const TypedQuantity typed = typedQuantity(text.toStdString(), {unit_, unit_ == "K", false});
    if (!typed.value) return std::nullopt;
    given.number = *typed.value;
  }
  return given;
}

void LessonPane::check() {
  const std::optional<GivenAnswer> given = typedAnswer();
  if (!given) {
    const QString unit = QString::fromStdString(unit_);
    showNote(unit.isEmpty() ? tr("A number is needed, such as 0.5.")
                            : tr("A number is needed, in %1.").arg(unit));
    if (number_) number_->setFocus();
    return;
  }
  emit answered(*given);
}

void LessonPane::setWaiting(bool isWaiting) {
  isWaiting_ = isWaiting;
  showButtons();
  showNote(isWaiting ? tr("The program computes the answer…") : QString());
}

void LessonPane::setPointPlaced(bool isPlaced) {
  isPointPlaced_ = isPlaced;
  showButtons();
}

void LessonPane::showNote(const QString& text) {
  note_->setText(text.toHtmlEscaped());
  note_->setVisible(!text.isEmpty());
  if (!text.isEmpty()) QTimer::singleShot(0, this, &LessonPane::scrollToNote);
}

/// Scrolls down as far as a note needs that is out of sight.
void LessonPane::scrollToNote() {
  if (note_->isVisible()) scroll_->ensureWidgetVisible(note_, 0, kNoteMargin);
}

void LessonPane::showButtons() {
  bool isAnswered = true;
  if (isAsking_) {
    if (kind_ == PredictionKind::Point) isAnswered = isPointPlaced_;
    if (choices_) isAnswered = choices_->checkedId() >= 0;
    if (number_) isAnswered = !number_->text().trimmed().isEmpty();
  }
  back_->setEnabled(!isFirst_ && !isWaiting_);
  show_->setVisible(isAsking_);
  show_->setEnabled(!isWaiting_);
  next_->setText(isAsking_ ? tr("Check") : isLast_ ? tr("Finish") : tr("Next"));
  next_->setEnabled(isAnswered && !isWaiting_);
  next_->setMinimumWidth(widestText(*this, {tr("Check"), tr("Finish"), tr("Next")}) + 26);
}

void LessonPane::focusStep() {
  if (isAsking_ && choices_ && !choices_->buttons().isEmpty())
    choices_->buttons().constFirst()->setFocus();
  else if (isAsking_ && number_)
    number_->setFocus();
  else if (next_->isEnabled())
    next_->setFocus();
  else
    text_->setFocus();
}

void LessonPane::keyPressEvent(QKeyEvent* event) {
  const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (isEnter && next_->isEnabled()) return next_->click();
  QWidget::keyPressEvent(event);
}

void LessonPane::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  const bool hasOtherLetters = event->type() == QEvent::FontChange;
  if (hasOtherLetters && next_) {
    setHeading();
    showButtons();
  }
  if ((hasOtherLetters || event->type() == QEvent::PaletteChange) && choices_)
    input_->setStyleSheet(choiceStyle(palette(), fontMetrics()));
}

}  // namespace asperity
