// The window in which a teacher writes a lesson: steps are added from the scene of the main window,
// ordered, and written on their pages (lesson_pages.h). Each change is checked as a file would be;
// the lesson can be tried at once. GUI thread. Failure: one line shows the error and its position;
// the lesson cannot be saved until it is corrected.
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
  /// file: the file of the lesson; empty: a dialog asks for it. shownNow: returns a step with the
  /// scene of the window.
  LessonEditor(const Lesson& lesson, const QString& file, std::function<LessonStep()> shownNow,
               QWidget* parent);

  /// Returns the lesson as it is on the page, which may still have errors.
  const Lesson& lesson() const { return lesson_; }
  /// Returns the error message; empty without an error.
  QString errorText() const { return errorText_; }

  void addShownStep();
  void removeStep();
  void moveStep(int by);
  /// Returns whether it was written.
  bool saveTo(const QString& file);
  /// Asks where changes would be lost.
  bool canClose();

 signals:
  void trialRequested(const asperity::Lesson& lesson, int step);

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
  QString file_, errorText_;
  std::function<LessonStep()> shownNow_;
  bool isShowing_ = false;  // the list is being filled

  QListWidget* steps_;
  QTabBar* language_;
  QStackedWidget* pages_;
  LessonHeadPage* head_;
  LessonStepPage* step_;
  QLabel* messageLabel_;
  QPushButton *add_, *remove_, *up_, *down_, *try_, *open_, *handout_, *save_, *close_;
  HandoutSaver* saver_;
};

}  // namespace asperity
