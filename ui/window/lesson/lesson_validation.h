// The validation of a lesson in the editor, in the words and units of the editor: what the lesson
// lacks, mistakes in its predictions, and the answers that the program computes in the background.
// The reader of its file (core/lesson/lesson_file.h) refuses the same, in the words of the file.
// GUI thread; owned by the editor.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/lesson/lesson_answers.h"
#include "ui/window/tasks/background_work.h"

namespace asperity {

class InputError;
class LessonDocument;

class LessonValidation : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Finds the first mistake, gives the steps the scenes that they have in the lesson as read, and
  /// computes answers: those that may be covered by no choice, without which the lesson is not
  /// played, and that of the present step (-1: none), which is shown. unreadable: what the page of
  /// that step cannot read; empty: nothing.
  void check(LessonDocument& document, int present, const QString& unreadable);
  /// Returns the mistake; empty without one.
  const QString& error() const { return error_; }
  /// Returns whether an answer has to be computed before the lesson can be played.
  bool isComputing() const { return isComputing_; }
  /// Returns whether any answer is being computed, also one that is only shown.
  bool hasWork() const { return pending_.has_value(); }
  /// Returns why the lesson cannot be played, or not yet; empty where it can.
  QString whyNotPlayed() const;
  /// Returns the text about the computed answer of the present step.
  QString computedText(const LessonStep& step) const;
  /// Forgets all answers: another lesson is checked from now on.
  void forget();

 signals:
  /// Emitted when an answer is computed; the lesson can be checked further.
  void answerFound();

 private:
  /// A number or a point that a step asks for.
  struct Computed {
    LessonStep asked{};  // of the step, what the answer depends on
    LessonAnswer answer{};
    QString failure{};  // why there is none
  };

  const Computed* computed(const LessonStep& step) const;
  bool compute(const LessonStep& step);
  void keep(Computed known);
  bool checkAnswers(const Lesson& lesson, int present);
  void stop();

  QString error_;
  bool isComputing_ = false, isReadable_ = true;  // the page of the present step can be read
  std::vector<Computed> computed_;
  std::optional<Computed> pending_;  // the number that is being computed
  BackgroundWork computing_;         // last: its thread ends before other members are destroyed
};

/// Returns the texts that lack this language and have the other one, as "step 1, title"; none where
/// nothing is written in this language.
QStringList missingTexts(const Lesson& lesson, bool inGerman);

/// Returns whether the curve of a step, in sight before the answer, shows the number that it asks
/// for.
bool showsAnswer(const LessonStep& step);

}  // namespace asperity
