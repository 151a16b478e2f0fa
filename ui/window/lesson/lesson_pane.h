// The pane of a lesson: the text of a step, the question with its choices or its number, the right
// answer, and its foot, a widget of its own with the buttons to go on. It holds no lesson: it shows
// a step and reports the student's actions by signals. GUI thread; owned by its parent. Cannot
// fail.
#pragma once

#include <QWidget>
#include <optional>

#include "core/lesson/lesson_answers.h"

class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace asperity {

class AnswerInput;

/// The content of the pane. The pointers need to be valid only during the call of showStep().
struct LessonPage {
  const Lesson* lesson = nullptr;
  int step = 0;
  std::string unit{};                    // of a number that is asked
  const LessonAnswer* answer = nullptr;  // where it is revealed
  const GivenAnswer* given = nullptr;    // the same
  bool isRight = false;
  QString score{};  // HTML, above the buttons
};

class LessonPane : public QWidget {
  Q_OBJECT

 public:
  explicit LessonPane(QWidget* parent = nullptr);

  /// The line of the buttons, which its owner shows in a place where they do not move.
  QWidget& foot() { return *foot_; }

  void showStep(const LessonPage& page);
  /// Returns whether the step asks a question that is not answered yet.
  bool isAsking() const { return isAsking_; }
  /// Shows that the answer is still being computed, after "Check" was pressed.
  void setWaiting(bool isWaiting);
  /// Shows a note below the answer, such as the reason why it cannot be computed.
  void showNote(const QString& text);
  /// Returns what the student has entered and not checked yet; enter() enters it again where the
  /// same question is shown anew.
  QString entry() const;
  void enter(const QString& entry);
  /// Reports that a point was placed on the chart.
  void setPointPlaced(bool isPlaced);

  /// Puts the focus where a student answers, or reads.
  void focusStep();
  /// Goes on as Enter does: checks the answer, or leads to the next step.
  void goOn();

 signals:
  void backRequested();
  void nextRequested();
  /// Emitted when the student has answered; the chart has the answer of a point.
  void answered(const asperity::GivenAnswer& given);
  void solutionRequested();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QLabel* addText(QVBoxLayout& column, const char* name);
  void buildFoot();
  void setInput(AnswerInput* input);
  void scroll();
  void scrollToStep();
  void scrollToNote();
  void showButtons();
  void check();

  QScrollArea* scroll_;
  QWidget* foot_;
  AnswerInput* input_ = nullptr;  // of the question of the step; null: it has none here
  QVBoxLayout* inputLayout_;
  QLabel *title_, *text_, *question_, *tolerance_, *verdict_, *reveal_, *note_, *score_, *progress_;
  QPushButton *back_ = nullptr, *show_ = nullptr, *next_ = nullptr;
  bool isAsking_ = false, isWaiting_ = false, isLast_ = false, isFirst_ = true;
  std::optional<PredictionKind> kind_;
  bool isPointPlaced_ = false;
  bool isRevealed_ = false, isScrolledByHand_ = false;
};

}  // namespace asperity
