// The friction diagram in the window: follows the session at a pace that leaves time for the rest,
// and turns what a user does in it into velocities. A new curve is shown at once; what has become
// stale a moment later, if nothing new is there by then; refinements now and then. GUI thread;
// belongs to its parent. Cannot fail.
#pragma once

#include <QObject>
#include <QTimer>

#include "core/scene/scene.h"
#include "ui/chart/chart_view.h"

namespace asperity {

class Session;

class CurveDisplay : public QObject {
  Q_OBJECT

 public:
  CurveDisplay(Session& session, ChartView& view, QObject* parent);

 signals:
  /// The scene with another velocity, from the marker or from a point.
  void sceneEdited(const asperity::Scene& scene);

 private:
  void showSoon();
  void show();
  void showMarker();
  void setVelocity(double velocity);

  Session& session_;
  ChartView& view_;
  QTimer pause_;        // runs after the diagram was painted
  bool isDue_ = false;  // and something came meanwhile
  bool wasStale_ = false;
};

}  // namespace asperity
