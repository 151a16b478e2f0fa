// The friction diagram in the window. It follows the session slowly enough to leave time for other
// work, and turns the user's actions in it into values of the swept key. A new curve is shown at
// once; a stale curve fades a moment later, if no new one has come; refinements are shown from time
// to time. GUI thread; owned by its parent. Cannot fail.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "core/scene/scene.h"
#include "ui/chart/chart_view.h"

namespace asperity {

class Session;

class CurveDisplay : public QObject {
  Q_OBJECT

 public:
  CurveDisplay(Session& session, ChartView& view, QObject* parent);

 signals:
  /// Emitted with the scene that has another value of the swept key, from the marker or a point.
  void sceneEdited(const asperity::Scene& scene);

 private:
  void showSoon();
  void show();
  void showMarker();
  void setSwept(double value);

  Session& session_;
  ChartView& view_;
  QTimer pause_;        // runs after the diagram was painted
  bool isDue_ = false;  // a change arrived meanwhile
  bool wasStale_ = false;
  std::optional<double> requested_;  // the newest value of the swept key that was set here
};

}  // namespace asperity
