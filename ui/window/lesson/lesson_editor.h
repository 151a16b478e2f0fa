// The window in which a teacher writes a lesson: steps are added from the scene of the main window,
// ordered, and written on their pages (lesson_pages.h). Each change is checked as a file would be;
// answers that no choice may cover are computed in the background. Every edit can be undone, and
// the lesson can be tried at once. GUI thread. Failure: one line shows the error and its position;
// until it is corrected the lesson is saved as a draft, which the editor opens again.
#pragma once

#include <QDialog>
#include <QString>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "core/lesson/lesson_answers.h"
#include "core/lesson/lesson_file.h"
#include "ui/window/tasks/background_work.h"

class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;
class QTabBar;
class QTimer;

namespace asperity {

class HandoutSaver;
class InputError;
class LessonHeadPage;
class LessonStepPage;

class LessonEditor : public QDialog {
  Q_OBJECT

 public:
  /// The step that the window shows; none where it shows no scene, but the gallery.
  using ShownNow = std::function<std::optional<LessonStep>()>;
  /// The lesson after an edit of the step in a row of the list.
  struct State {
    Lesson lesson;
    int row = 0;
    QString field{};  // name of the field in which it was typed; empty: a button, a list or a table
  };
  /// What another editor needs to continue: the lesson, its file and its edits, and what is shown.
  struct Session {
    Lesson lesson, saved;
    QString file;
    std::vector<State> states;
    std::size_t state = 0;
    int row = 0;
    int language = 0;
    QByteArray geometry;
  };

  /// file: the file of the lesson; empty: a dialog asks for it.
  LessonEditor(const Lesson& lesson, const QString& file, ShownNow shownNow, QWidget* parent);

  Session session() const;
  /// Shows the lesson of another editor as it was there.
  void restoreSession(const Session& session);
  /// Shows a lesson as an edit of the saved one.
  void showDraft(const Lesson& lesson);

  /// Returns the lesson as it is on the page, which may still have errors.
  const Lesson& lesson() const { return lesson_; }
  /// Returns the error message; empty without an error.
  QString errorText() const { return errorText_; }
  /// Returns whether an answer has to be computed before the lesson can be played.
  bool isComputing() const { return isComputing_; }
  /// Returns whether any answer is being computed, also one that is only shown.
  bool hasWork() const { return pending_.has_value(); }

  void addShownStep();
  void removeStep();
  void moveStep(int by);
  /// Gives the present step the scene that the window shows. The steps after it keep theirs.
  void takeShownScene();
  void undo() { restore(-1); }
  void redo() { restore(1); }
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
  /// A number or a point that a step asks for.
  struct Computed {
    LessonStep asked{};  // of the step, what the answer depends on
    LessonAnswer answer{};
    QString failure{};  // why there is none
  };

  QWidget* buildSteps();
  QLayout* buildFoot();
  void showList();
  void showStep();
  void take();
  void check();
  QString whyNotPlayed() const;
  void remember();
  void keepSoon();
  void keepUnsaved();
  void forgetUnsaved();
  void restore(int by);
  void keepOwnScene(std::size_t step);
  void showError(const InputError& error);
  void takeScenes(const Lesson& read);
  std::optional<LessonStep> takenStep();
  void showMissing();
  const Computed* computed(const LessonStep& step) const;
  bool compute(const LessonStep& step);
  bool checkAnswers();
  void stopComputing();
  QString computedText() const;
  bool askAndSave();
  QWidget* questionParent();
  void showButtons();
  Lesson checked() const;
  std::filesystem::path folder() const;
  void openOther();
  LessonStep* present();
  QString stepName(std::size_t step) const;
  QString sceneText(std::size_t step) const;
  bool isGerman() const;

  Lesson lesson_;
  Lesson saved_;
  QString file_, errorText_;
  ShownNow shownNow_;
  bool isShowing_ = false;     // the list is being filled
  bool isComputing_ = false;   // an answer is being computed that the lesson needs to be played
  std::vector<State> states_;  // of the lesson, for undo and redo
  std::size_t state_ = 0;      // the present one
  QString typedIn_;            // name of the field in which the user types; empty: none
  std::vector<Computed> computed_;
  std::optional<Computed> pending_;  // the number that is being computed

  QListWidget* steps_;
  QTabBar* language_;
  QStackedWidget* pages_;
  LessonHeadPage* head_;
  LessonStepPage* step_;
  QLabel* messageLabel_;
  QPushButton *add_, *remove_, *up_, *down_, *try_, *open_, *handout_, *save_, *saveAs_, *close_,
      *undo_, *redo_;
  HandoutSaver* saver_;
  QTimer* keeping_;           // runs until what was edited is kept against a crash
  BackgroundWork computing_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
