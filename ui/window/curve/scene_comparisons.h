// Keeps theories and measured friction beside the present friction curve, as the scene names them:
// read and computed in the background when the curve is complete. GUI thread; owned by its
// parent. Failure: one sentence by `failed`; the next change tries again.
#pragma once

#include <QObject>
#include <optional>

#include "core/friction/curve_quantity.h"
#include "core/scene/scene.h"
#include "ui/window/tasks/background_work.h"

namespace asperity {

class Session;

class SceneComparisons : public QObject {
  Q_OBJECT

 public:
  SceneComparisons(Session& session, QObject* parent);

 signals:
  void failed(const QString& reason);
  /// Emitted when comparisons are shown: an earlier failure is over.
  void shown();

 private:
  void update();

  Session& session_;
  std::optional<Scene> compared_;               // the scene of the last comparison
  CurveQuantity quantity_ = CurveQuantity::Mu;  // of the last comparison
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
