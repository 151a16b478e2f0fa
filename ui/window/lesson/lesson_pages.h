// The two pages of the lesson editor: the lesson as a whole, and one step. GUI thread; belong to
// the editor.
#pragma once

#include "ui/window/lesson/lesson_form.h"

class QSpinBox;
class QToolButton;

namespace asperity {

class PredictionFields;

/// Title, goal, duration, notes for teachers.
class LessonHeadPage : public LessonForm {
  Q_OBJECT

 public:
  explicit LessonHeadPage(QWidget* parent = nullptr);

  void showLesson(const Lesson& lesson);
  void take(Lesson& lesson) const;

 private:
  QLineEdit* title_;
  QPlainTextEdit *goal_, *notes_;
  QSpinBox* minutes_;
};

/// Title, text, scene, what is shown and free, and the prediction.
class LessonStepPage : public LessonForm {
  Q_OBJECT

 public:
  explicit LessonStepPage(QWidget* parent = nullptr);

  void showStep(const LessonStep& step);
  void take(LessonStep& step) const;
  /// Puts the focus into the text, which is marked.
  void beginText();

 private:
  void fillControls();
  void showControls();
  void chooseOthers();
  void chooseControl(const std::string& key, bool isFree);

  QLineEdit* title_;
  AssignmentList* set_;
  QPlainTextEdit* text_;
  QComboBox *tab_, *quantity_, *others_;
  QToolButton* controls_;
  PredictionFields* prediction_;
  LessonControls chosen_;  // of the step that is shown
  Scene scene_;            // after its reveal
};

}  // namespace asperity
