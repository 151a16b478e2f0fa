// The main window's tabs under the contact: what is known of the scene.
#include <QAction>
#include <QTabBar>
#include <QTabWidget>
#include <cmath>

#include "core/run/line_diagrams.h"
#include "core/run/transient_diagram.h"
#include "ui/chart/chart_view.h"
#include "ui/window/accuracy/accuracy_panel.h"
#include "ui/window/accuracy/plan_list.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/session.h"

namespace asperity {

namespace {

constexpr int kMotionTab = 1;

/// Of the points that have such a value; NaN where none has.
double rootMeanSquare(const std::vector<CurvePoint>& points, double (*value)(const CurvePoint&)) {
  double squares = 0;
  int count = 0;
  for (const CurvePoint& point : points)
    if (const double one = value(point); std::isfinite(one)) {
      squares += one * one;
      ++count;
    }
  return count > 0 ? std::sqrt(squares / count) : kNotApplicable;
}

}  // namespace

/// What is known of the scene, under the contact; the motion's strips only where it has one.
QTabWidget* MainWindow::buildTabs() {
  strips_ = new ChartView;
  strips_->setObjectName("transientStrips");
  strips_->setFocusPolicy(Qt::NoFocus);
  strips_->setAccessibleName(tr("velocity, friction, indentation and contact length in time"));
  plan_ = new PlanList;
  tabs_ = new QTabWidget;
  tabs_->setObjectName("tabs");
  tabs_->setAccessibleName(tr("about the scene"));
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setFocusPolicy(Qt::NoFocus);  // Space is the run's
  tabs_->tabBar()->setDrawBase(false);
  tabs_->addTab(plot_, tr("Friction curve"));
  tabs_->addTab(strips_, tr("Motion in time"));
  spectrum_ = new DiagramView;
  spectrum_->setObjectName("spectrumView");
  spectrum_->setAccessibleName(tr("spectrum of the rigid line"));
  tabs_->addTab(spectrum_, tr("Spectrum"));
  statistics_ = new DiagramView;
  statistics_->setObjectName("statisticsView");
  statistics_->setAccessibleName(tr("pressures and slopes in contact"));
  tabs_->addTab(statistics_, tr("Statistics"));
  accuracy_ = new AccuracyPanel;
  tabs_->addTab(accuracy_, tr("Accuracy"));
  tabs_->addTab(plan_, tr("Plan"));
  tabs_->setTabVisible(kMotionTab, false);
  return tabs_;
}

/// The tabs for this scene; the motion comes to the front where it is new, and goes with it.
void MainWindow::showAboutScene() {
  const Sliding& sliding = session_->scene().sliding;
  const bool moves = sliding.kind != SlidingKind::Steady;
  const bool moved = tabs_->isTabVisible(kMotionTab);
  // Left before it goes: the next tab would come to the front, which is not the curve's.
  if (!moves && tabs_->currentWidget() == strips_) tabs_->setCurrentWidget(plot_);
  QAction& action = *tabActions_.at(kMotionTab);
  action.setVisible(moves);
  tabs_->setTabVisible(kMotionTab, moves && action.isChecked());
  if (moves && !moved) tabs_->setCurrentIndex(kMotionTab);
  if (moves) strips_->setSheet(transientSheet(session_->scene(), {}));
  plan_->showScene(session_->scene());
  spectrum_->show([scene = session_->scene()] { return spectrumSheet(scene); });
  accuracy_->showScene(session_->scene());
  if (!timed_ || !haveSameCurve(*timed_, session_->scene())) {
    timed_ = session_->scene();
    curveTime_.start();
    measured_.reset();
  } else if (measured_) {
    showMeasured(*measured_);
  }
}

/// Once, when the present scene's curve is complete.
void MainWindow::showMeasuredCurve() {
  const CurveUpdate* curve = session_->curve();
  if (!curveTime_.isValid() || !curve || !curve->isComplete) return;
  const auto& points = curve->points;
  showMeasured(
      {1e-3 * static_cast<double>(curveTime_.elapsed()),
       rootMeanSquare(points, [](const CurvePoint& at) { return at.muStandardError / at.mu; }),
       rootMeanSquare(points,
                      [](const CurvePoint& at) { return (at.muHigh - at.muLow) / 2 / at.mu; })});
  curveTime_.invalidate();
}

void MainWindow::showMeasured(const Measured& measured) {
  measured_ = measured;
  accuracy_->showMeasured(measured.seconds, measured.standardError, measured.interval);
}

}  // namespace asperity
