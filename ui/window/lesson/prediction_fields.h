// The rows of the lesson editor for the question of a step: the kind of prediction, the question,
// the choices, the computed answer, and the texts and actions after it is revealed. The rows are
// those of a page. GUI thread; owned by the page.
#pragma once

#include <QObject>
#include <string>

#include "core/lesson/lesson.h"

class QComboBox;
class QLabel;
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
  /// Writes the rows into the step. Members that the rows do not show are kept, and so are those
  /// whose numbers cannot be read.
  void take(LessonStep& step) const;
  /// Returns an error that names the first field without a readable number; empty without an error.
  QString unreadable() const;
  /// Shows the text about the computed answer; empty: the row is hidden.
  void showComputed(const QString& text);

 private:
  void addChoices();
  void emptySelectedCells();
  void showChoices(const LessonPrediction& prediction);
  bool takeChoices(LessonPrediction& prediction) const;
  void showRows();
  void showRowsOfPoint();
  void proposeTolerance();
  QString unreadableIn(const QLineEdit& line) const;
  QString unreadableChoice() const;

  LessonForm& page_;
  QComboBox *kind_, *hides_;
  QPlainTextEdit *question_, *reveal_;
  QLineEdit *x_, *tolerance_, *xTolerance_, *right_, *wrong_;
  AssignmentList* after_;
  QTableWidget* choices_;
  LessonValueFields* value_;
  QLabel* computed_;
  std::string axis_;  // the key of the axis of the step's curve
  bool isLinearY_ = false;
};

}  // namespace asperity
