// The two pages of the lesson editor: the lesson as a whole, and one step. GUI thread; owned by the
// editor.
#pragma once

#include "ui/window/lesson/lesson_form.h"

class QLabel;
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
  /// Puts the focus into the title.
  void beginTitle();

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

  /// Shows a step. `sceneText`: the name of its scene.
  void showStep(const LessonStep& step, const QString& sceneText);
  /// Writes the fields into the step. Where a number cannot be read, the step keeps its own.
  void take(LessonStep& step) const;
  PredictionFields& prediction() { return *prediction_; }
  /// Puts the focus into the text and selects it.
  void beginText();

 signals:
  /// Emitted when the step is to get the scene that the main window shows.
  void shownSceneRequested();

 private:
  void addScene();
  void fillControls();
  void showControls();
  void chooseOthers();
  void chooseControl(const std::string& key, bool isFree);

  QLineEdit* title_;
  AssignmentList* set_;
  QPlainTextEdit* text_;
  QComboBox *tab_, *quantity_, *others_;
  QToolButton* controls_;
  QLabel* sceneText_;
  PredictionFields* prediction_;
  LessonControls chosen_;  // of the step that is shown
  Scene scene_;            // after its reveal
};

}  // namespace asperity
