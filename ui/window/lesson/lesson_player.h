// A lesson that runs in the window: it opens the scenes of the steps, frees and locks the controls,
// hides the curve until it was guessed, and compares answers with what the program computes. The
// user's own scene, curves and axes come back when the lesson ends. Owned by the main window; GUI
// thread. Failure: a note in the pane shows the reason; the lesson stays.
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/friction/curve_quantity.h"
#include "core/lesson/lesson_results.h"
#include "core/run/runner.h"
#include "ui/contact/contact_picture.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/tasks/background_work.h"

class QDockWidget;
class QMainWindow;

namespace asperity {

class Commands;
class ContactCanvas;
class LessonDock;
class LessonPane;
class ParameterPanel;
class PredictionPoint;
class SceneTabs;
class Session;
class WindowPages;

class LessonPlayer : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    QMainWindow& window;
    SceneDocument& document;
    Session& session;
    ContactCanvas& canvas;
    ParameterPanel& panel;
    QDockWidget& parameters;
    SceneTabs& tabs;
    WindowPages& pages;
  };
  explicit LessonPlayer(const Parts& parts);

  /// Replaces lessonAnswer(), which computes the right answers on a thread of its own.
  void setAnswerFunction(AnswerFunction find) { find_ = std::move(find); }

  void addTo(Commands& commands);

  /// Begins a lesson at a step, with the answers that are known; no other one may run. A trial is
  /// of a teacher, who tries a step in the editor.
  void start(const Lesson& lesson, int step, const LessonResults& known, bool isTrial);
  void show(int step);
  /// Ends the lesson and brings the user's scene back.
  void end();

  bool isRunning() const { return lesson_ != nullptr; }
  /// Returns the lesson with whole questions; null where none runs.
  const Lesson* lesson() const { return lesson_.get(); }
  int step() const { return step_; }
  bool isTrial() const { return isTrial_; }
  /// Returns whether the answer of the present step is visible, or there is none.
  bool isRevealed() const;
  const LessonResults& results() const { return results_; }
  /// Takes results that a file has in addition.
  void setResults(LessonResults results) { results_ = std::move(results); }
  LessonPane& pane() { return *pane_; }
  PredictionPoint& point() { return *point_; }

 signals:
  /// Emitted when a step or its answer is shown.
  void stepShown();
  /// Emitted when the results have an answer more, before it is shown.
  void answered();
  /// Emitted when the student wants to save the results, or to end the lesson.
  void savingRequested();
  void endRequested();
  void ended();

 private:
  const LessonStep& present() const { return lesson_->steps[static_cast<std::size_t>(step_)]; }
  void translateStep();
  void showPage();
  void showTitle();
  void showScene();
  Scene shownScene() const;
  void showControls();
  void lockControls();
  void showChart();
  void showBeside();
  void showPoint();
  QString summary() const;
  void findAnswer();
  void stopFinding();
  void takeAnswer(const LessonAnswer& answer);
  void answer(GivenAnswer given, bool givesUp);
  void settle(const GivenAnswer& given);
  void next();
  void keepWindow();
  void restoreWindow();

  Parts parts_;
  LessonDock* dock_;
  LessonPane* pane_;
  PredictionPoint* point_;
  Commands* commands_ = nullptr;
  std::unique_ptr<Lesson> lesson_;
  int step_ = 0;
  bool isTrial_ = false;
  AnswerFunction find_ = lessonAnswer;
  std::map<int, LessonAnswer> answers_;  // computed ones, by step
  std::optional<GivenAnswer> waiting_;   // given, while the right answer is computed
  LessonResults results_;

  /// The state before the lesson, which its end restores; the document keeps the user's scene.
  struct Before {
    std::vector<std::shared_ptr<const CurveUpdate>> pinned{};
    CurveQuantity quantity;
    bool isLinearY;
    int tab;
    bool hasDimensionlessAxes = false, hasComparison = false;
    ContactOverlay overlay{};
  };
  std::optional<Before> before_;
  BackgroundWork comparisons_;  // curves to compare with
  BackgroundWork finding_;      // last: its thread ends before other members are destroyed
};

}  // namespace asperity
