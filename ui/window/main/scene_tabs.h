// The tabs under the contact: what is known of the scene. The friction curve, the motion in time
// (only where the scene has one), the spectrum of the line, statistics of the contact, what
// accuracy costs, and the plan. GUI thread; belongs to its parent.
#pragma once

#include <QElapsedTimer>
#include <QList>
#include <QTabWidget>
#include <functional>
#include <optional>

#include "core/run/frame.h"
#include "core/scene/scene.h"
#include "ui/contact/contact_picture.h"

class QAction;
class QMenu;

namespace asperity {

class AccuracyPanel;
class Commands;
class DiagramView;
class PlanList;
class ChartView;
class Session;

class SceneTabs : public QTabWidget {
  Q_OBJECT

 public:
  explicit SceneTabs(Session& session, QWidget* parent = nullptr);

  ChartView& plot() { return *plot_; }
  AccuracyPanel& accuracy() { return *accuracy_; }

  /// A key for each tab, which brings it to the front.
  void addTo(Commands& commands);
  /// A submenu: which tabs there are. The motion's comes and goes with the scene.
  void addMenu(QMenu& menu);

  /// The tabs' object names: settings outlive versions, so a tab is kept by its name.
  QStringList hiddenTabs() const;
  void hideTabs(const QStringList& names);

  /// The motion comes to the front where it is new, and goes with it.
  void showScene(const Scene& scene);
  void showFrame(const Frame& frame);
  void setTheme(const Theme& theme);

  /// The curve is timed from now on: it is averaged anew.
  void beginCurve();

  /// The fields that frames have to hold for the tab in front.
  FrameFields fields() const;
  /// Whether the motion in time is in front.
  bool isShowingMotion() const;

 signals:
  void fieldsWanted();

 private:
  void showTexts();
  void bringToFront(int index);
  void setWanted(int index, bool isWanted);
  void showMeasuredCurve();

  Session& session_;
  ChartView* plot_;
  ChartView* strips_;
  DiagramView *spectrum_, *statistics_;
  AccuracyPanel* accuracy_;
  PlanList* plan_;
  Commands* commands_ = nullptr;
  QList<QAction*> wanted_;      // one for each tab, checkable
  std::optional<Scene> timed_;  // whose curve is timed
  QElapsedTimer curveTime_;     // since it was wanted; invalid once there
  /// Errors are relative, root mean square; of the present curve.
  struct Measured {
    double seconds, standardError, interval;
  };
  std::optional<Measured> measured_;
};

}  // namespace asperity
