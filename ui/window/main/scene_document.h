// The scene as a document: its undo history, where it came from, and whether it differs from what
// was opened or saved last. Every change is a step from one immutable Scene to the next; changes of
// the same parameters within one gesture (a drag, a key held down) are one step. Owned by the main
// window; GUI thread. Cannot fail.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

/// Where a scene can be read again: a shipped scene by its name, a file by its path, or nothing.
struct SceneOrigin {
  QString shipped;  // "figure_1"
  QString file;     // of JSON
  Scene scene;      // as it reads

  bool isKnown() const { return !shipped.isEmpty() || !file.isEmpty(); }
};

class SceneDocument : public QObject {
  Q_OBJECT

 public:
  explicit SceneDocument(const Scene& scene, QObject* parent = nullptr);
  ~SceneDocument() override;

  /// A fresh document: no history, unchanged.
  void open(const SceneOrigin& origin);

  /// The next step. `gesture`: steps of one number may merge. `what`: for the menu, a source text
  /// of MainWindow; null: named after the parameters that differ. Nothing where the scene is the
  /// present one.
  void change(const Scene& scene, std::uint64_t gesture, const char* what = nullptr);

  /// The steps' names anew, in the language in use.
  void nameSteps();

  /// The present scene is now what the file says.
  void saved(const QString& file);

  const Scene& scene() const { return scene_; }
  const SceneOrigin& origin() const { return origin_; }

  /// The file that saving writes; empty: a name is needed.
  QString file() const { return origin_.file; }

  /// "figure_1.json": what a scene without a file may be saved as, by the shipped scene that it
  /// came from, or by its title.
  QString proposedFile() const;

  /// By value: a slider moved and moved back leaves the scene unchanged.
  bool isChanged() const { return !(scene_ == origin_.scene); }

  QUndoStack& history() { return history_; }

 signals:
  /// Undo or redo came to this scene.
  void sceneWanted(const asperity::Scene& scene);
  /// Scene, origin or history are others than before.
  void changed();

 private:
  friend class SceneStep;
  void goTo(const Scene& scene);

  Scene scene_;
  SceneOrigin origin_;
  QUndoStack history_;
};

/// Keys of the parameters in which the scenes differ, in the table's order.
std::vector<std::string_view> differingKeys(const Scene& a, const Scene& b);

/// What a step between two scenes is called: "Normal force", "3 parameters".
QString stepName(const Scene& before, const Scene& after);

}  // namespace asperity
