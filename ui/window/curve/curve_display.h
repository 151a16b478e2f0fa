// The friction diagram in the window. It follows the session slowly enough to leave time for other
// work, and turns the user's actions in it into values of the swept key. A new curve is shown at
// once; a stale curve fades a moment later, if no new one has come; refinements are shown from time
// to time. Beside the present curve, each on a thread of its own, are computed: the difference of
// another setting, and the theories and measured friction that the scene names. That work begins
// when the scene's own curve is complete, because that comes first. GUI thread; owned by their
// parent. Failure: the message bar shows the reason; the next change tries again.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>
#include <string>

#include "core/chart/curve_set.h"
#include "core/friction/curve_difference.h"
#include "core/friction/curve_quantity.h"
#include "core/scene/scene.h"
#include "ui/chart/chart_view.h"
#include "ui/window/tasks/background_work.h"

namespace asperity {

class AxisBox;
class ChartView;
class CurveCommands;
class MessageBar;
class Session;

/// What the axes of the curve show. A zoomed range belongs to them.
struct CurveAxesChoice {
  std::string key;  // that is swept
  SweepScale xScale = SweepScale::Logarithmic;
  CurveAxes axes = CurveAxes::Physical;
  CurveQuantity quantity = CurveQuantity::Mu;
  bool isLinearY = false;

  bool operator==(const CurveAxesChoice&) const = default;
};

/// Shows the session's diagram.
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
  CurveAxesChoice axes_;             // of the diagram that is shown
  std::optional<double> requested_;  // the newest value of the swept key that was set here
};

/// The difference of two settings, which is shown as it grows.
class CurveComparison : public QObject {
  Q_OBJECT

 public:
  CurveComparison(Session& session, MessageBar& messages, QObject* parent);

  /// Sets the other setting; none: no comparison.
  void setSetting(const std::optional<CurveSetting>& setting);

 private:
  void update();

  Session& session_;
  MessageBar& messages_;
  std::optional<CurveSetting> setting_;
  std::optional<Scene> compared_;  // the scene of the last comparison
  BackgroundWork work_;            // last: its thread ends before other members are destroyed
};

/// Theories and measured friction, as the scene names them.
class SceneComparisons : public QObject {
  Q_OBJECT

 public:
  SceneComparisons(Session& session, MessageBar& messages, QObject* parent);

 private:
  void update();

  Session& session_;
  MessageBar& messages_;
  std::optional<Scene> compared_;               // the scene of the last comparison
  CurveQuantity quantity_ = CurveQuantity::Mu;  // of the last comparison
  BackgroundWork work_;  // last: its thread ends before other members are destroyed
};

/// The lists at the axes of the chart, instead of their titles: the parameter of the horizontal
/// axis and the quantity of the vertical axis. They offer the same choices as the menu of the
/// curve, whose commands they call. Owned by the commands; the chart owns the lists.
class AxisChoosers : public QObject {
  Q_OBJECT

 public:
  AxisChoosers(Session& session, ChartView& view, CurveCommands& commands);

 private:
  void fillKeys();
  void fillQuantities();
  void update();
  void explain();
  void showTexts();
  void showTitles(const QString& x, const QString& y);

  Session& session_;
  CurveCommands& commands_;
  AxisBox *x_, *y_;
};

}  // namespace asperity
