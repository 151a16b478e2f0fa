// The window in which a teacher writes a lesson: steps are added from what the main window shows,
// put in order, and written on their pages (lesson_pages.h). Everything is checked as a file
// would be, whenever it changes; it can be tried at once. GUI thread. Failure: one line says what
// is wrong and where; nothing of it is saved meanwhile.
#pragma once

#include <QDialog>
#include <QString>
#include <functional>

#include "core/lesson/lesson_file.h"

class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;
class QTabBar;

namespace asperity {

class HandoutSaver;
class LessonHeadPage;
class LessonStepPage;

class LessonEditor : public QDialog {
  Q_OBJECT

 public:
  /// file: where it is saved; empty: asks. shownNow: a step with what the window shows.
  LessonEditor(const Lesson& lesson, const QString& file, std::function<LessonStep()> shownNow,
               QWidget* parent);

  /// The lesson as it is on the page, which may not be right yet.
  const Lesson& lesson() const { return lesson_; }
  /// What is wrong; empty where nothing is.
  QString complaint() const { return complaint_; }

  void addShownStep();
  void removeStep();
  void moveStep(int by);
  /// Returns whether it was written.
  bool saveTo(const QString& file);
  /// Asks where changes would be lost.
  bool mayClose();

 signals:
  void tryWanted(const asperity::Lesson& lesson, int step);

 protected:
  void reject() override;

 private:
  QWidget* buildSteps();
  QLayout* buildFoot();
  void showList();
  void showStep();
  void take();
  void check();
  void showButtons();
  Lesson checked() const;
  void openOther();
  LessonStep* present();
  QString nameOf(std::size_t step) const;
  bool isGerman() const;

  Lesson lesson_;
  Lesson saved_;
  QString file_, complaint_;
  std::function<LessonStep()> shownNow_;
  bool isShowing_ = false;  // the list is being filled

  QListWidget* steps_;
  QTabBar* language_;
  QStackedWidget* pages_;
  LessonHeadPage* head_;
  LessonStepPage* step_;
  QLabel* said_;
  QPushButton *add_, *remove_, *up_, *down_, *try_, *open_, *handout_, *save_, *close_;
  HandoutSaver* saver_;
};

}  // namespace asperity
