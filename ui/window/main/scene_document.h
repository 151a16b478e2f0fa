// The scene as a document: its undo history, where it came from, and whether it differs from what
// was opened or saved last. Every change is a step from one immutable Scene to the next; changes of
// the same parameters within one gesture (a drag, a key held down) are one step. This is the one
// place that holds the window's scene; everything that shows it follows sceneChanged(). Owned by
// the main window; GUI thread. Cannot fail.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

class GestureCounter;

/// Where a scene can be read again: a shipped scene by its name, a file by its path, or nothing.
struct SceneOrigin {
  QString shipped;  // "figure_1"
  QString file;     // of JSON
  Scene scene;      // as it reads

  bool isKnown() const { return !shipped.isEmpty() || !file.isEmpty(); }
};

/// Opened: the scene has nothing to do with the one before.
enum class SceneChange { Edited, Opened };

class SceneDocument : public QObject {
  Q_OBJECT

 public:
  explicit SceneDocument(const Scene& scene, QObject* parent = nullptr);
  ~SceneDocument() override;

  /// A fresh document: no history, unchanged. Asks nothing.
  void open(const SceneOrigin& origin);
  void open(const Scene& scene) { open(SceneOrigin{{}, {}, scene}); }

  /// The next step, within the present gesture of the user. `what` names it in the menu, a source
  /// text of this class; null: it is named after the parameters that differ. Nothing happens where
  /// the scene is the present one.
  void edit(const Scene& scene, const char* what = nullptr);
  /// The same for a gesture of this number: steps of one number may merge.
  void change(const Scene& scene, std::uint64_t gesture, const char* what = nullptr);

  /// Every parameter to its default; what a scene says of itself holds for its parameters.
  void resetAll();
  /// The scene as it was opened or saved last.
  void revert();

  /// The present scene is now what the file says.
  void saved(const QString& file);

  /// A scene to play with, as a step of the tour is: nobody is asked to save it. Until open().
  void setTrial(bool isTrial) { isTrial_ = isTrial; }
  /// Whether changes would be lost with the document that somebody may want.
  bool needsSaving() const { return isChanged() && !isTrial_; }

  /// The title of the scene, or else the name of its file; may be empty.
  QString name() const;

  const Scene& scene() const { return scene_; }
  const SceneOrigin& origin() const { return origin_; }

  /// The file that saving writes; empty: a name is needed.
  QString file() const { return origin_.file; }

  /// "figure_1.json": what a scene without a file may be saved as, by the shipped scene that it
  /// came from, or by its title.
  QString proposedFile() const;

  /// Compares values: a slider that is moved and moved back leaves the scene unchanged.
  bool isChanged() const { return !(scene_ == origin_.scene); }

  QUndoStack& history() { return history_; }

 signals:
  /// Another document takes the place of this one; sceneChanged() follows.
  void opening();
  /// The scene is another one, whatever changed it: a control, undo, a file.
  void sceneChanged(const asperity::Scene& scene, asperity::SceneChange change);
  /// Origin or history are others than before, or have other names.
  void historyChanged();

 private:
  friend class SceneStep;
  void goTo(const Scene& scene);
  void nameSteps();

  Scene scene_;
  SceneOrigin origin_;
  bool isTrial_ = false;
  GestureCounter* gestures_;
  QUndoStack history_;
};

/// Keys of the parameters in which the scenes differ, in the table's order.
std::vector<std::string_view> differingKeys(const Scene& a, const Scene& b);

/// Returns the name of a step between two scenes: "Normal force", "3 parameters".
QString stepName(const Scene& before, const Scene& after);

}  // namespace asperity
