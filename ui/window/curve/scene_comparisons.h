// Keeps theories and measured friction beside the present friction curve, as the scene names them:
// read and computed in the background when the curve is complete. GUI thread; belongs to its
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
  void follow();

  Session& session_;
  std::optional<Scene> compared_;               // the scene last begun with
  CurveQuantity quantity_ = CurveQuantity::Mu;  // likewise
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

}  // namespace asperity
