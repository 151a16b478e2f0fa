// A student's results as a page to read: which lesson, how many answers are right, and what was
// answered. GUI thread. Failure: InputError where the file holds no results.
#pragma once

#include <QCoreApplication>
#include <QString>

class QWidget;

namespace asperity {

class LessonResultsPage {
  Q_DECLARE_TR_FUNCTIONS(asperity::LessonResultsPage)

 public:
  /// Returns the summary as HTML. Answers of a shipped lesson are given with their questions.
  static QString html(const QString& file);
};

/// Shows the summary in a dialog, which may stay open.
void showLessonResults(QWidget& window, const QString& file);

}  // namespace asperity
