// The rows of the lesson editor for the question of a step: the kind of prediction, the question,
// the choices, the computed answer (lesson_value_fields.h), and the texts and actions after it is
// revealed. The rows are those of a page. GUI thread; owned by the page.
#pragma once

#include <QObject>

#include "core/lesson/lesson.h"

class QComboBox;
class QLineEdit;
class QPlainTextEdit;
class QTableWidget;

namespace asperity {

class AssignmentList;
class LessonForm;
class LessonValueFields;

class PredictionFields : public QObject {
  Q_OBJECT

 public:
  explicit PredictionFields(LessonForm& page);

  /// Fills the rows. Call it within LessonForm::fill().
  void show(const LessonStep& step);
  /// Writes the rows into the step. Members that the rows do not show are kept.
  void take(LessonStep& step) const;

 private:
  void addChoices();
  void emptySelectedCells();
  void showChoices(const LessonPrediction& prediction);
  bool takeChoices(LessonPrediction& prediction) const;
  void showRows();

  LessonForm& page_;
  QComboBox* kind_;
  QPlainTextEdit* question_;
  QLineEdit *x_, *tolerance_, *right_, *wrong_;
  AssignmentList* after_;
  QTableWidget* choices_ = nullptr;
  LessonValueFields* value_;
  QComboBox* hides_;
  QPlainTextEdit* reveal_;
};

}  // namespace asperity
