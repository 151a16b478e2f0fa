// The window in which a teacher writes a lesson: steps are added from the scene of the main window,
// ordered, and written on their pages (lesson_pages.h). Each change is checked as a file would be
// (lesson_validation.h), can be undone (lesson_document.h), and the lesson can be tried at once.
// GUI thread. Failure: one line shows the error and its position; until it is corrected the lesson
// is saved as a draft, which the editor opens again.
#pragma once

#include <QDialog>
#include <QString>
#include <functional>
#include <optional>

#include "ui/window/lesson/lesson_document.h"
#include "ui/window/lesson/lesson_validation.h"

class QLabel;
class QListWidget;
class QPushButton;
class QScrollArea;
class QStackedWidget;
class QTabBar;
class QTimer;

namespace asperity {

class HandoutSaver;
class LessonHeadPage;
class LessonStepPage;

class LessonEditor : public QDialog {
  Q_OBJECT

 public:
  /// The step that the window shows; none where it shows no scene, but the gallery.
  using ShownNow = std::function<std::optional<LessonStep>()>;
  /// What another editor needs to continue: the lesson with its edits, and what is shown.
  struct Session {
    LessonDocument document;
    int row = 0;
    int language = 0;
    QByteArray geometry;
  };

  LessonEditor(LessonDocument document, ShownNow shownNow, QWidget* parent);

  Session session() const;
  /// Shows the lesson, which is that of another editor, as it was shown there.
  void restoreSession(const Session& session);

  /// Returns the lesson as it is on the page, which may still have errors.
  const Lesson& lesson() const { return document_.lesson; }
  /// Returns the error message; empty without an error.
  const QString& errorText() const { return validation_->error(); }
  bool isComputing() const { return validation_->isComputing(); }
  bool hasWork() const { return validation_->hasWork(); }
  HandoutSaver& saver() { return *saver_; }

  void addShownStep();
  void removeStep();
  void moveStep(int by);
  /// Gives the present step the scene that the window shows. The steps after it keep theirs.
  void takeShownScene();
  void undo();
  void redo();
  /// Opens a lesson in place of the present one, whose changes are lost. Where it cannot be read, a
  /// line shows the error.
  void openFile(const QString& file);
  /// Saves the lesson, which may be a draft. Returns whether the file was written.
  bool saveTo(const QString& file);
  /// Saves to the file of the lesson, or asks for it where it has none.
  bool save();
  /// Asks whether unsaved changes are to be saved, and saves them. Returns whether it may close.
  bool canClose();

 signals:
  void trialRequested(const asperity::Lesson& lesson, int step);

 protected:
  void reject() override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildLanguages();
  QWidget* buildSteps();
  QLayout* buildFoot();
  void useRead(const std::function<void(const Lesson&)>& use);
  int presentStep() const;
  LessonStep* present();
  bool isGerman() const;
  QString stepName(std::size_t step) const;
  QString sceneText(std::size_t step) const;
  void showList();
  void showStep();
  void showEdit(int row);
  void showChange(int row);
  void showMissing();
  void showButtons();
  void take();
  void check();
  void keepSoon();
  void forgetUnsaved();
  std::optional<LessonStep> takenStep();
  void openOther();
  QString proposedFile() const;
  bool askAndSave();
  QWidget* questionParent();

  LessonDocument document_;
  ShownNow shownNow_;
  bool isShowing_ = false;  // the list is being filled
  int shownRow_ = -1;       // the step that is shown; -1: the lesson
  QString typedIn_;         // name of the field in which the user types; empty: none

  QListWidget* steps_;
  QTabBar* language_;
  QStackedWidget* pages_;
  QScrollArea* scroll_;  // of the page of a step
  LessonHeadPage* head_;
  LessonStepPage* step_;
  QLabel* messageLabel_;
  QPushButton *remove_, *up_, *down_, *try_, *handout_, *undo_, *redo_;
  LessonValidation* validation_;
  HandoutSaver* saver_;
  QTimer* keeping_;  // runs until what was edited is kept against a crash
};

}  // namespace asperity
