// A lesson in the window: it opens the scenes of the steps, frees and locks the controls, hides the
// curve until it was guessed, compares answers with what the program computes, and keeps the
// results in a file of the student's choice. The user's own scene, curves and axes come back when
// the lesson ends. Owned by the main window; GUI thread. Failure: the message bar shows the reason;
// the lesson, or the user's scene, stays.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_results.h"
#include "ui/chart/friction_chart_model.h"
#include "ui/contact/contact_picture.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/tasks/background_work.h"

class QAction;
class QDockWidget;
class QMainWindow;
class QLabel;
class QToolButton;

namespace asperity {

class Appearance;
class Commands;
class LessonEditor;
class LessonList;
class LessonPane;
class MessageBar;
class ParameterPanel;
class PredictionPoint;
class SceneTabs;
class Session;

class Lessons : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    QMainWindow& window;
    SceneDocument& document;
    Session& session;
    ParameterPanel& panel;
    QDockWidget& parameters;
    SceneTabs& tabs;
    MessageBar& messages;
    Appearance& appearance;
  };
  explicit Lessons(const Parts& parts);
  ~Lessons() override;

  void addTo(Commands& commands);

  /// Shows the page of all lessons.
  LessonList& showList();
  /// Returns the page on which a lesson is edited, also while a trial hides it; null without one.
  LessonEditor* editor() const;
  /// Shows the page on which a lesson is edited. `file`: of the lesson; empty: it has none.
  LessonEditor& showEditor(const Lesson& lesson, const QString& file);
  /// Learning: answers count and are kept. Trial: a teacher tries a step in the editor.
  enum class Purpose { Learning, Trial };
  /// Begins a lesson at a step; it replaces the present one.
  void start(const Lesson& lesson, int step = 0, Purpose purpose = Purpose::Learning);
  /// Closes the editor, and returns what opens it again as it was, to be called in another
  /// language.
  std::function<void()> closeEditorForReopening();
  /// Shows the same page, or the lesson of an earlier session that was never saved if the user
  /// wants to go on with it.
  LessonEditor& openEditor(const Lesson& lesson, const QString& file);
  /// Reads a lesson's file, or a shipped one by its name, and begins it; returns whether it did.
  /// Answers of an earlier session that are in no file are offered. Of a student's results it shows
  /// a summary.
  bool open(const QString& nameOrFile);
  /// Shows the results of a class side by side; returns whether any file has results.
  bool openResults(const QStringList& files);
  /// Ends the lesson and brings the user's scene back.
  void end();
  /// Asks whether answers that are in no file are to be saved; returns whether the lesson may end.
  bool mayLeave();
  /// Asks the same about answers and about the lesson in the editor; returns whether the window may
  /// close.
  bool canClose();
  /// Closes the editor without a question, and ends the lesson.
  void close();

  bool isRunning() const { return lesson_ != nullptr; }
  const Lesson* lesson() const { return lesson_.get(); }
  int step() const { return step_; }
  /// Returns whether the answer of the present step is visible, or there is none.
  bool isRevealed() const;
  const LessonResults& results() const { return results_; }
  LessonPane& pane() { return *pane_; }
  PredictionPoint& point() { return *point_; }

  /// Keeps the results in this file from now on, together with those of this lesson that are in it
  /// already. Returns false, with the reason in the message bar, where the file cannot be used.
  bool keepResults(const QString& file);

 signals:
  /// Emitted when a step or its answer is shown.
  void stepShown();
  void ended();

 private:
  const LessonStep& present() const { return lesson_->steps[static_cast<std::size_t>(step_)]; }
  void buildDock();
  void show(int step);
  void showPage();
  void showScene();
  void showControls();
  void showChart();
  void findAnswer();
  void takeAnswer(int step, const LessonAnswer& answer);
  void answer(GivenAnswer given, bool givesUp);
  void settle(const GivenAnswer& given);
  void next();
  void leave();
  bool hasUnsavedAnswers() const;
  void keepUnsavedAnswers() const;
  void offerAnswers(const Lesson& lesson);
  bool wantsToGoOn(const QString& name, const QString& question) const;
  LessonEditor& makeEditor(const Lesson& lesson, const QString& file);
  void hideDuringLesson(LessonEditor& editor);
  QString failureText(const QString& file, const std::exception& error) const;
  void askResultsFile();
  QString resultsName() const;
  void writeResultsFile();
  void lockControls(const Scene& scene);
  void restore();
  QString summary() const;
  void showTitle();

  Parts parts_;
  QDockWidget* dock_;
  QLabel* title_;
  QToolButton *keep_, *close_;
  LessonPane* pane_;
  PredictionPoint* point_;
  Commands* commands_ = nullptr;
  std::unique_ptr<Lesson> lesson_;  // with whole questions
  Lesson written_;                  // the same as it was written
  int step_ = 0;
  std::map<int, LessonAnswer> answers_;
  std::optional<GivenAnswer> waiting_;  // given, while the right answer is computed
  LessonResults results_;
  QString file_;  // of the lesson; empty: a shipped one, or one that was never saved
  QString resultsFile_;
  bool isSaved_ = false;  // the file has the results
  bool isTrial_ = false;  // from the editor: its answers are not kept
  /// Answers of lessons that were left for another scene, by the digest of the lesson.
  std::map<std::string, LessonResults> left_;

  /// The state before the lesson, which its end restores; the document keeps the user's scene.
  struct Before {
    std::vector<std::shared_ptr<const CurveUpdate>> pinned;
    CurveQuantity quantity;
    bool isLinearY;
    int tab;
    bool hasDimensionlessAxes;
    ContactOverlay overlay;
  };
  std::optional<Before> before_;
  BackgroundWork comparisons_;  // curves to compare with
  BackgroundWork finding_;      // last: its thread ends before other members are destroyed
};

}  // namespace asperity
