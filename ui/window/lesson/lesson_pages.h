// The two pages of the lesson editor: the lesson as a whole, and one step. GUI thread; belong to
// the editor.
#pragma once

#include "ui/window/lesson/lesson_form.h"

class QLabel;
class QSpinBox;
class QTableWidget;
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

  /// sceneText: which scene it is, in words.
  void showStep(const LessonStep& step, const QString& sceneText);
  /// Takes over what is written. A number that cannot be read leaves what the step has.
  void take(LessonStep& step) const;
  /// Returns which field has no number where it needs one, and what is in it; empty: none.
  QString unreadable() const;
  /// Says what is computed as the answer; empty: nothing is.
  void showComputed(const QString& text);
  /// Puts the focus into the text, which is marked.
  void beginText();

 signals:
  /// Emitted where the step shall have the scene that the main window shows.
  void shownSceneWanted();

 private:
  void addScene();
  void addPredictionRows();
  void showRowsOfPoint();
  QString unreadableIn(const QLineEdit& line, bool mayBeEmpty) const;
  QString unreadableChoice() const;
  void fillControls();
  void showControls();
  void chooseOthers();
  void chooseControl(const std::string& key, bool isFree);

  QLineEdit* title_;
  AssignmentList* set_;
  QPlainTextEdit* text_;
  QComboBox *tab_, *quantity_, *others_;
  QToolButton* controls_;
  QLabel *sceneText_, *computed_;
  PredictionFields* prediction_;
  // Of the rows of the prediction.
  QComboBox *kind_, *hides_;
  QLineEdit *x_, *tolerance_, *xTolerance_;
  QTableWidget* choices_;
  LessonControls chosen_;  // of the step that is shown
  std::string axis_;       // the key of its curve's axis
  Scene scene_;            // after its reveal
};

}  // namespace asperity
