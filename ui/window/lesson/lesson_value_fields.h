// The rows of the lesson editor for a number that the program computes as the answer: a column of
// the curve, its ratio to the value of the step, the position of its largest value, or the exponent
// with which it depends on a key. GUI thread; owned by the page.
#pragma once

#include <QObject>
#include <optional>
#include <string>

#include "core/lesson/lesson.h"

class QComboBox;
class QLineEdit;

namespace asperity {

class AssignmentList;
class LessonForm;

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

/// Returns a parameter's value with its unit, as in "5 \u00B5m/s".
QString keyValueText(const std::string& key, double value);

/// Reads such a text; a number without a unit is in SI. Returns nothing where there is no number.
std::optional<double> parseKeyValue(const std::string& key, const QString& text);

}  // namespace asperity
