// Keeps the difference of two settings beside the present friction curve: computed on a thread of
// its own when the curve is complete, shown in the session's diagram as it grows. GUI thread;
// belongs to its parent. Failure: one sentence by `failed`; the next change tries again.
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

  /// None: no comparison.
  void setSetting(const std::optional<CurveSetting>& setting);

 signals:
  void failed(const QString& reason);
  /// Some of a difference is there: whatever failed before is over.
  void shown();

 private:
  void follow();
  void start();
  void take(const CurveDifference& difference);

  Session& session_;
  std::optional<CurveSetting> setting_;
  std::optional<Scene> compared_;  // the scene last begun with
  BackgroundWork work_;            // last: its thread ends before anything else here goes
};

}  // namespace asperity
