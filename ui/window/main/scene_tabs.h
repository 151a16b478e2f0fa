// The tabs under the contact: the friction curve, the motion over time (only where the scene has
// one), the spectrum of the line, statistics of the contact, the moduli of the elastomer with the
// frequencies in use, the cost of accuracy, the plan, the map over two parameters, and the
// influences on friction. GUI thread; owned by its parent.
#pragma once

#include <QElapsedTimer>
#include <QStringList>
#include <QTabWidget>
#include <memory>
#include <optional>
#include <vector>

#include "core/run/frame.h"
#include "core/scene/scene.h"
#include "ui/draw/theme.h"
#include "ui/language/language.h"
#include "ui/window/accuracy/accuracy_panel.h"

class QAction;
class QMenu;

namespace asperity {

class ChartView;
class Commands;
class DiagramView;
class ExcitationCache;
class InfluencePage;
class MapPanel;
class MotionView;
class PlanList;
class Session;

class SceneTabs : public QTabWidget {
  Q_OBJECT

 public:
  explicit SceneTabs(Session& session, QWidget* parent = nullptr);

  ChartView& plot() { return *plot_; }
  DiagramView& material() { return *material_; }
  AccuracyPanel& accuracy() { return *accuracy_; }
  MapPanel& map() { return *map_; }
  MotionView& motion() { return *motion_; }

  /// Returns a title in the language of the window.
  using Title = QString (*)();
  /// Adds the last tab; the brief title is for a narrow bar. What the page's diagrams report is
  /// reported by the tabs.
  void addPage(QWidget& page, Title title, Title brief = nullptr);

  /// Adds a key for each tab, which brings it to the front.
  void addTo(Commands& commands);
  /// Adds a submenu that shows and hides tabs. The motion's tab exists only with a motion.
  void addMenu(QMenu& menu);

  /// Returns the object names of the hidden tabs; names outlive versions of the program in the
  /// settings.
  QStringList hiddenTabs() const;
  void hideTabs(const QStringList& names);
  /// Sets whether titles may be scrolled by buttons, as with the large letters of a presentation on
  /// a small screen. Otherwise all titles fit into the minimum width.
  void setMayScroll(bool mayScroll);
  QSize minimumSizeHint() const override;

  /// Shows a widget beside the titles of the tabs, or leaves its space to them.
  void showInCorner(QWidget& widget, bool isShown);

  /// Brings the tab of this object name to the front, if it is shown.
  void bringToFront(const QString& name);

  /// Disables the tabs that would reveal a hidden curve, except for the one in front.
  void setCurveHidden(bool isHidden);

  /// Updates the tabs. A new motion comes to the front; its tab leaves with it.
  void showScene(const Scene& scene);
  void showFrame(const Frame& frame);
  /// Empties what counts in a frame: there is none of the scene.
  void clearFrame();
  void setTheme(const Theme& theme);

  /// Starts the timer of the curve, whose averaging begins again.
  void beginCurve();

  /// Returns the optional values that frames need for the front tab.
  FrameFields fields() const;
  /// Returns whether the tab of the motion is in front.
  bool isShowingMotion() const;

 signals:
  void fieldsChanged();
  /// Emitted when a diagram was saved or copied, or could not be drawn, saved or copied.
  void saved(const QString& file);
  void copied();
  void failed(const asperity::LiveText& reason);

 protected:
  /// Paints nothing: Qt would paint the base of a tab bar beside the tabs, which have none.
  void paintEvent(QPaintEvent*) override {}
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Page {
    Title title, brief;
    QAction* action;  // checked: the page is shown
  };

  void showTexts();
  void fitTitles();
  const Page& pageAt(int index) const { return pages_[static_cast<std::size_t>(index)]; }
  void addKey(int index);
  int tabsWidth(Title Page::*title, int padding) const;
  int cornerWidth() const;
  void bringToFront(int index);
  void setTabRequested(int index, bool isRequested);
  void showMeasuredCurve();

  Session& session_;
  ChartView* plot_;
  MotionView* motion_;
  DiagramView *spectrum_, *statistics_, *material_;
  AccuracyPanel* accuracy_;
  PlanList* plan_;
  MapPanel* map_;
  InfluencePage* influences_;
  Commands* commands_ = nullptr;
  QMenu* menu_ = nullptr;
  std::vector<Page> pages_;     // one for each tab
  std::optional<Scene> timed_;  // the scene whose curve is timed
  int narrowestTabs_ = 0;       // pixels that the bar needs, with its corner
  bool mayScroll_ = false;
  QElapsedTimer curveTime_;  // since the request for the curve; invalid once it is complete
  std::optional<CurveCost> measured_;  // results for the present curve
  std::shared_ptr<ExcitationCache> excitation_;
};

}  // namespace asperity
