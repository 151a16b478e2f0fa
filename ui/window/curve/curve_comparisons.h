// What is computed beside the present friction curve, each on a thread of its own: the difference
// of another setting, and the theories and measured friction that the scene names. The work begins
// when the scene's own curve is complete, because that comes first; the session's diagram then
// shows the result. GUI thread; owned by their parent. Failure: `failed` gives one sentence; the
// next change tries again.
#pragma once

#include <QObject>
#include <optional>

#include "core/friction/curve_difference.h"
#include "core/friction/curve_quantity.h"
#include "core/scene/scene.h"
#include "ui/window/tasks/background_work.h"

namespace asperity {

class Session;

/// The difference of two settings, which is shown as it grows.
class CurveComparison : public QObject {
  Q_OBJECT

 public:
  CurveComparison(Session& session, QObject* parent);

  /// Sets the other setting; none: no comparison.
  void setSetting(const std::optional<CurveSetting>& setting);

 signals:
  void failed(const QString& reason);
  /// Emitted when part of a difference is available, so that an earlier failure is over.
  void shown();

 private:
  void update();

  Session& session_;
  std::optional<CurveSetting> setting_;
  std::optional<Scene> compared_;  // the scene of the last comparison
  BackgroundWork work_;            // last: its thread ends before other members are destroyed
};

/// Theories and measured friction, as the scene names them.
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
