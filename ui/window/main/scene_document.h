// The scene as a document: its undo history, its origin, and whether it differs from the scene that
// was opened or saved last. Every change is a step from one immutable Scene to the next; changes of
// the same parameters within one gesture (a drag, a key held down) are one step, and so is opening
// another scene: undo restores the previous one, with its changes and its file. A trial, as in the
// guided tour or a lesson, has a history of its own, and its end restores the scene before it. This
// is the only place that holds the window's scene; everything that shows it follows sceneChanged().
// Owned by the main window; GUI thread. Cannot fail.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

class GestureCounter;

/// The source of a scene: a shipped scene with its name, a file with its path, or none.
struct SceneOrigin {
  QString shipped;  // "figure_1"
  QString file;     // path of a JSON file
  Scene scene;      // the scene as it was read

  bool isKnown() const { return !shipped.isEmpty() || !file.isEmpty(); }
};

/// A scene as the user left it, and where it came from.
struct SceneState {
  SceneOrigin origin;
  Scene scene;

  /// Returns whether the scene differs from the file that it came from.
  bool isUnsavedFile() const { return !origin.file.isEmpty() && !(scene == origin.scene); }
};

/// The kind of change. Opened: the scene is unrelated to the one before.
enum class SceneChange { Edited, Opened };

class SceneDocument : public QObject {
  Q_OBJECT

 public:
  explicit SceneDocument(const Scene& scene, QObject* parent = nullptr);
  ~SceneDocument() override;

  /// Shows another scene, as one step of the history. A trial ends before.
  void open(const SceneOrigin& origin);
  void open(const Scene& scene) { open(SceneOrigin{{}, {}, scene}); }

  /// Begins with this scene, without a history, as at the start of the program.
  void begin(const SceneState& state);

  /// Shows a scene that is tried out, as in a step of the tour. The first call begins a trial,
  /// which has a history of its own; a further one shows the next scene of the trial with a new
  /// history.
  void openTrial(const SceneOrigin& origin);
  /// Returns from a trial to the scene before it, with its history; does nothing without one.
  void endTrial();
  bool isTrial() const { return beforeTrial_.has_value(); }

  /// Returns the present scene or, during a trial, the one to which its end returns.
  SceneState lastingState() const {
    return beforeTrial_ ? *beforeTrial_ : SceneState{origin_, scene_};
  }

  /// Makes the next step, within the present gesture of the user. `what` names it in the menu, a
  /// source text of this class; null: it is named after the parameters that differ. Nothing happens
  /// where the scene is the present one.
  void edit(const Scene& scene, const char* what = nullptr);
  /// Makes a step for the gesture of this number: steps of one number may merge.
  void change(const Scene& scene, std::uint64_t gesture, const char* what = nullptr);

  /// Sets every parameter to its default; the scene's title and description then no longer apply.
  void resetAll();
  /// Returns to the scene that was opened or saved last.
  void revert();

  /// Declares that the file now contains the present scene.
  void saved(const QString& file);

  /// Returns the scenes that came from files and differ from them: the present one first, then
  /// those that were left for another scene and can only be reached by undo, or not even by it
  /// where the history is long. A file is named once, with its newest state. Nothing that is tried
  /// out counts.
  std::vector<SceneState> unsavedFiles() const;

  /// Returns the title of the scene or, without one, the name of its file; may be empty.
  QString name() const;

  const Scene& scene() const { return scene_; }
  const SceneOrigin& origin() const { return origin_; }

  /// Returns the file to which saving writes; empty: a name is needed.
  QString file() const { return origin_.file; }

  /// Returns a name such as "figure_1.json" for a scene without a file, from the shipped scene
  /// whose title it has, or from its title.
  QString proposedFile() const;
  QString fileOrProposal() const { return file().isEmpty() ? proposedFile() : file(); }

  /// Compares values: moving a slider there and back leaves the scene unchanged.
  bool isChanged() const { return !(scene_ == origin_.scene); }

  /// Returns the history of the trial, or of the document where there is none.
  QUndoStack& history() { return isTrial() ? trialHistory_ : history_; }

 signals:
  /// Emitted before another scene replaces this one; sceneChanged() follows.
  void opening();
  /// Emitted when a trial ends, before the scene before it returns.
  void trialEnded();
  /// Emitted when the scene has changed, by a control, undo or a file.
  void sceneChanged(const asperity::Scene& scene, asperity::SceneChange change);
  /// Emitted when origin or history have changed, or their names.
  void historyChanged();

 private:
  friend class SceneStep;
  void goTo(const SceneState& state, SceneChange change);
  void nameSteps();

  Scene scene_;
  SceneOrigin origin_;
  std::optional<SceneState> beforeTrial_;      // the state to which the end of a trial returns
  std::map<QString, SceneState> leftUnsaved_;  // by file: unsaved scenes when they were left
  GestureCounter* gestures_;
  QUndoStack history_, trialHistory_;
};

/// Returns the keys of the parameters in which the scenes differ, in the table's order.
std::vector<std::string_view> differingKeys(const Scene& a, const Scene& b);

/// Returns the name of a step between two scenes: "Normal force", "3 parameters".
QString stepName(const Scene& before, const Scene& after);

}  // namespace asperity
