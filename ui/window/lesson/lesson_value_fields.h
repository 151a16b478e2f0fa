// The rows of the lesson editor for a computed answer. GUI thread; owned by the page.
#pragma once

#include <QObject>

#include "core/lesson/lesson.h"

class QComboBox;
class QLineEdit;

namespace asperity {

class AssignmentList;
class LessonForm;

/// The rows for a number that the program computes as the answer: a column of the curve, its ratio
/// to the value of the step, the position of its largest value, or the exponent with which it
/// depends on a key.
class LessonValueFields : public QObject {
  Q_OBJECT

 public:
  explicit LessonValueFields(LessonForm& page);

  /// Fills the rows. scene: that of the step, whose keys can be chosen for an exponent.
  void show(const LessonValue& value, const Scene& scene);
  void setShown(bool isShown);
  /// Returns the value with the contents of the rows. Members that the rows do not show are kept.
  LessonValue edited(const LessonValue& before) const;

 private:
  void showRows();
  void proposeEnds();
  double rangeEnd(const QLineEdit& entry) const;

  LessonForm& page_;
  QComboBox *kind_, *column_, *key_;
  QLineEdit *from_, *to_;
  AssignmentList* set_;
  Scene scene_;  // of the step
  bool isShown_ = true;
};

}  // namespace asperity
