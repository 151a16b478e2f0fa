// The page of all lessons: what each teaches and how long it takes, for teachers also its answers;
// it begins one, opens a file, and writes handouts. GUI thread. Failure: one line on the page shows
// the error.
#pragma once

#include <QDialog>
#include <QString>
#include <map>
#include <vector>

#include "core/lesson/lesson_answers.h"
#include "ui/window/tasks/background_work.h"

class QCheckBox;
class QLabel;
class QLayout;
class QListWidget;
class QPushButton;

namespace asperity {

class HandoutSaver;

class LessonList : public QDialog {
  Q_OBJECT

 public:
  /// answer: computes the right answer to the question of a step, on a thread of its own.
  explicit LessonList(QWidget* parent, AnswerFunction answer = lessonAnswer);

  /// Returns the name of the chosen shipped lesson.
  QString chosen() const;
  HandoutSaver& saver() { return *saver_; }

 signals:
  /// Emitted with the name of a shipped lesson, or a file.
  void lessonRequested(const QString& nameOrFile);
  /// Emitted with several files, which are to be results of students.
  void resultsRequested(const QStringList& files);
  void editorRequested(const QString& nameOrFile);

 private:
  QLayout* buildAbout();
  QLayout* buildFoot();
  void showTexts();
  void showChosen();
  void showAbout();
  void computeAnswers(int row);
  QString teacherText(int row) const;
  void askFile();
  void begin();

  AnswerFunction answer_;
  QListWidget* list_;
  QCheckBox* notes_;
  QLabel *about_, *status_;
  QPushButton *start_, *open_, *handout_, *edit_, *close_;
  HandoutSaver* saver_;
  std::map<int, std::vector<LessonAnswer>> answers_;  // of the steps of the lessons, by row
  int computedRow_ = -1;  // of the lesson whose answers are computed; -1: none
  BackgroundWork answering_;
};

}  // namespace asperity
