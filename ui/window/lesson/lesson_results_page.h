// Results of students as pages to read: of one student, which lesson, how many answers are right,
// and what was answered; of a class, the same of all students side by side. GUI thread. Failure:
// InputError where a file holds no results.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <functional>
#include <optional>
#include <vector>

#include "core/lesson/lesson_results.h"

class QWidget;

namespace asperity {

/// The table of a class for people, in the language of the window.
struct ClassRows {
  QStringList heading, answers;  // answers: the right ones
  std::vector<QStringList> students;
};

class LessonResultsPage {
  Q_DECLARE_TR_FUNCTIONS(asperity::LessonResultsPage)

 public:
  /// Returns the summary as HTML. Answers of a shipped lesson are given with their questions.
  static QString html(const QString& file);

  /// Returns the title of a lesson, in the language of the window where it is a shipped one.
  static QString lessonTitle(const LessonResults& results);

  /// Returns the table of the students in one lesson: a row for each student, and a column for each
  /// step that somebody answered.
  static ClassRows classRows(const std::vector<StudentResults>& students);

  /// Returns the results of a class as HTML, with a table for each lesson. Files without results
  /// are listed below with their reasons.
  static QString classHtml(const ClassResults& results);
};

/// Returns the shipped lesson to which results belong, as it was written; nothing for another
/// lesson or version.
std::optional<Lesson> shippedLesson(const LessonResults& results);

/// Shows the summary in a dialog, which may stay open. Where the lesson is a shipped one, a button
/// closes the dialog and calls `goOn` with lesson and results; an empty one has no button.
void showLessonResults(QWidget& window, const QString& file,
                       const std::function<void(const Lesson&, const LessonResults&)>& goOn = {});

/// Shows the results of a class in a dialog, which may stay open. A button of it saves them as the
/// table that `asperity lesson` writes.
void showClassResults(QWidget& window, const QStringList& files);

}  // namespace asperity
