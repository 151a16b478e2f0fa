// The pane of a lesson: the text of a step, the question with its choices or its number, what was
// right, and the buttons that lead on. It holds no lesson: it shows a step and tells what the
// student does. The buttons stay where they are. GUI thread; belongs to its parent. Cannot fail.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/lesson/lesson_answers.h"

class QButtonGroup;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace asperity {

/// What the pane shows. The pointers are valid during the call of showStep().
struct LessonPage {
  const Lesson* lesson = nullptr;
  int step = 0;
  std::string unit{};                    // of a number that is asked
  const LessonAnswer* answer = nullptr;  // where it is revealed
  const GivenAnswer* given = nullptr;    // the same
  bool isRight = false;
  QString remark{};  // the score: below the text, or below the answer of the step
};

class LessonPane : public QWidget {
  Q_OBJECT

 public:
  explicit LessonPane(QWidget* parent = nullptr);

  void showStep(const LessonPage& page);
  /// Whether the answer is still being computed, after "Check" was pressed.
  void setWaiting(bool isWaiting);
  /// Says something below the answer, such as why it cannot be computed.
  void showNote(const QString& text);
  /// Tells that a point was placed on the chart.
  void setPointPlaced(bool isPlaced);

  /// Puts the focus where a student answers, or reads.
  void focusStep();

 signals:
  void backWanted();
  void nextWanted();
  /// The student has answered; of a point, the chart knows the answer.
  void answered(const asperity::GivenAnswer& given);
  void surrendered();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QLabel* addText(QVBoxLayout& column, const char* name);
  void addChoices(const LessonPrediction& prediction, const LessonPage& page);
  void addNumber(const LessonPage& page);
  void clearInput();
  QString verdictOf(const LessonStep& step, const LessonPage& page) const;
  void setHeading();
  void scroll();
  void showButtons();
  void check();
  std::optional<GivenAnswer> typedAnswer() const;

  QScrollArea* scroll_;
  QWidget* input_ = nullptr;
  QVBoxLayout* inputPlace_;
  QLabel *title_, *text_, *question_, *verdict_, *reveal_, *note_, *progress_;
  QPushButton *back_, *show_, *next_;
  QButtonGroup* choices_ = nullptr;
  QLineEdit* number_ = nullptr;
  std::string unit_;
  bool isAsking_ = false, isWaiting_ = false, isLast_ = false, isFirst_ = true;
  std::optional<PredictionKind> kind_;
  bool isPointPlaced_ = false;
  bool isRevealed_ = false, isScrolledByHand_ = false;
};

}  // namespace asperity
