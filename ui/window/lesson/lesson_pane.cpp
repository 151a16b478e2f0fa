#include "ui/window/lesson/lesson_pane.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/language/language.h"
#include "ui/language/translated.h"
#include "ui/panels/controls.h"
#include "ui/panels/labels.h"
#include "ui/panels/number_text.h"
#include "ui/window/lesson/answer_input.h"
#include "ui/window/lesson/lesson_text.h"

namespace asperity {

namespace {

constexpr int kNoteMargin = 4;  // pixels below a note that is scrolled to
constexpr QLatin1String kList("<ul>"), kNarrowList("<ul style=\"margin-left: -22px\">");

/// A button that is no wider than its text needs, so that three of them fit beside each other.
class FootButton : public QPushButton {
 public:
  QSize sizeHint() const override {
    constexpr int kAround = 24;  // pixels beside the text
    return {fontMetrics().horizontalAdvance(text()) + kAround, QPushButton::sizeHint().height()};
  }
  QSize minimumSizeHint() const override { return sizeHint(); }
};

}  // namespace

LessonPane::LessonPane(QWidget* parent) : QWidget(parent) {
  setObjectName("lessonPane");
  auto* content = named<QWidget>("lessonContent");
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
  constexpr double kHeadingScale = 1.08;  // below that of the lesson, above the text
  keepHeading(*title_, *this, kHeadingScale);
  question_->setFont(boldFont(question_->font()));

  scroll_ = scrolled(content, Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);  // its texts take the focus
  buildFoot();
  auto* all = marginless<QVBoxLayout>(this, 0);
  all->addWidget(scroll_, 1);
  score_ = addText(*all, "lessonScore");  // in sight, however long the texts are
  score_->setContentsMargins(14, 6, 14, 6);

  // Texts get their heights one after the other, and others with the width of the window.
  connect(scroll_->verticalScrollBar(), &QScrollBar::rangeChanged, this, [this] {
    if (!isScrolledByHand_) scroll();
  });
  connect(scroll_->verticalScrollBar(), &QScrollBar::actionTriggered, this,
          [this] { isScrolledByHand_ = true; });
  keepTranslated(*this, [this] {
    back_->setText(tr("Back"));
    show_->setText(tr("Show me"));
    show_->setToolTip(tr("Shows the answer without a guess"));
    showButtons();
  });
}

void LessonPane::buildFoot() {
  progress_ = named<QLabel>("lessonProgress");
  back_ = named<FootButton>("lessonBack");
  show_ = named<FootButton>("lessonShow");
  next_ = named<FootButton>("lessonNext");
  foot_ = named<QWidget>("lessonFoot");
  foot_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* foot = new QHBoxLayout(foot_);
  foot->setContentsMargins(14, 6, 14, 8);
  foot->setSpacing(6);
  foot->addWidget(progress_, 1);
  for (QPushButton* one : {back_, show_, next_}) foot->addWidget(one);
  keepSpaceWhenHidden(*show_);
  connect(back_, &QPushButton::clicked, this, &LessonPane::backRequested);
  connect(show_, &QPushButton::clicked, this, &LessonPane::solutionRequested);
  connect(next_, &QPushButton::clicked, this, [this] {
    if (isAsking_)
      check();
    else
      emit nextRequested();
  });
}

QLabel* LessonPane::addText(QVBoxLayout& column, const char* name) {
  auto* label = named<QLabel>(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::RichText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  label->setFocusPolicy(Qt::TabFocus);
  column.addWidget(label);
  return label;
}

void LessonPane::showStep(const LessonPage& page) {
  const LessonStep& step = page.lesson->steps[static_cast<std::size_t>(page.step)];
  const auto fill = [](QLabel& label, QString html) {
    // The usual indentation of a list takes a fifth of the width of the pane.
    label.setText(html.replace(kList, kNarrowList));
    label.setVisible(!html.isEmpty());
  };
  const int count = static_cast<int>(page.lesson->steps.size());
  isFirst_ = page.step == 0;
  isLast_ = page.step + 1 == count;
  isWaiting_ = false;
  isPointPlaced_ = false;
  progress_->setText(tr("%1 of %2").arg(page.step + 1).arg(count));
  fill(*title_, lineText(step.title).toHtmlEscaped());
  fill(*text_, lessonHtml(shown(step.text)));
  fill(*score_, page.score);
  fill(*note_, {});
  isAsking_ = step.prediction && !page.answer;
  kind_.reset();
  if (step.prediction) kind_ = step.prediction->kind;
  fill(*question_,
       step.prediction ? lineText(step.prediction->question).toHtmlEscaped() : QString());
  fill(*tolerance_, step.prediction ? toleranceText(*step.prediction).toHtmlEscaped() : QString());
  AnswerInput* input = nullptr;
  if (kind_ == PredictionKind::Choice)
    input = new ChoiceInput(*step.prediction, page.answer, page.given);
  else if (isAsking_ && kind_ == PredictionKind::Number)
    input = new NumberInput(page.unit);
  setInput(input);
  QString verdict, reveal;
  if (step.prediction && page.answer) {
    verdict = verdictText(*step.prediction, *page.answer, *page.given, page.isRight);
    reveal = lessonHtml(step.reveal, *step.prediction, *page.answer, *page.given);
  }
  fill(*verdict_, verdict);
  // The focus moves to the button; its description gives the right answer to screen readers, or the
  // text of a step that asks nothing.
  next_->setAccessibleDescription(
      spokenText((step.prediction ? verdict + reveal : text_->text()) + page.score));
  fill(*reveal_, reveal);
  showButtons();
  isRevealed_ = page.answer != nullptr;
  isScrolledByHand_ = false;
  // All is in its place before anything of the step can be painted.
  QCoreApplication::sendPostedEvents(scroll_->widget(), QEvent::LayoutRequest);
  QTimer::singleShot(0, this, &LessonPane::scroll);
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

/// Shows the control with which the question is answered, or was; null: none.
void LessonPane::setInput(AnswerInput* input) {
  if (input_) {
    inputLayout_->removeWidget(input_);
    input_->setParent(nullptr);
    input_->deleteLater();
  }
  input_ = input;
  if (!input) return;
  connect(input, &AnswerInput::edited, this, &LessonPane::showButtons);
  connect(input, &AnswerInput::readAs, this, &LessonPane::showNote);
  connect(input, &AnswerInput::returnPressed, this, &LessonPane::goOn);
  inputLayout_->addWidget(input);
  input->show();  // at once: a layout shows what is added to it with a later event
  const QWidgetList controls = input->controls();
  // The focus moves to the first one, beyond the question.
  if (!controls.isEmpty())
    controls.constFirst()->setAccessibleDescription(spokenText(question_->text()));
  orderTabs(*tolerance_, *inputLayout_);  // below the question
}

QString LessonPane::entry() const {
  return input_ ? input_->entry() : QString();
}

void LessonPane::enter(const QString& entry) {
  if (input_ && isAsking_) input_->enter(entry);
}

void LessonPane::check() {
  const std::optional<GivenAnswer> given = input_ ? input_->answer() : GivenAnswer();
  if (given) return emit answered(*given);
  showNote(input_->refusal());
  input_->controls().constFirst()->setFocus();
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
  if (isAsking_) isAnswered = kind_ == PredictionKind::Point ? isPointPlaced_ : !entry().isEmpty();
  back_->setEnabled(!isFirst_ && !isWaiting_);
  show_->setVisible(isAsking_);
  show_->setEnabled(!isWaiting_);
  next_->setText(isAsking_ ? tr("Check") : isLast_ ? tr("Finish") : tr("Next"));
  next_->setEnabled(isAnswered && !isWaiting_);
  next_->setMinimumWidth(widestText(*this, {tr("Check"), tr("Finish"), tr("Next")}) + 26);
}

void LessonPane::focusStep() {
  if (isAsking_ && input_ && !input_->controls().isEmpty())
    input_->controls().constFirst()->setFocus();
  else if (next_->isEnabled())
    next_->setFocus();
  else
    text_->setFocus();
}

void LessonPane::goOn() {
  next_->click();  // nothing while it is disabled
}

void LessonPane::keyPressEvent(QKeyEvent* event) {
  if (isReturnKey(*event) && next_->isEnabled()) return goOn();
  QWidget::keyPressEvent(event);
}

void LessonPane::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange && next_) showButtons();
}

}  // namespace asperity
