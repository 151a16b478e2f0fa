// Computes the difference of two settings beside the present friction curve. The work begins on a
// thread of its own when the curve is complete, and the session's diagram shows the result as it
// grows. GUI thread; owned by its parent. Failure: `failed` gives one sentence; the next change
// tries again.
#pragma once

#include <QObject>
#include <optional>

#include "core/friction/curve_difference.h"
#include "ui/window/tasks/background_work.h"

namespace asperity {

class Session;

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
  void start();
  void take(const CurveDifference& difference);

  Session& session_;
  std::optional<CurveSetting> setting_;
  std::optional<Scene> compared_;  // the scene of the last comparison
  BackgroundWork work_;            // last: its thread ends before other members are destroyed
};

}  // namespace asperity
