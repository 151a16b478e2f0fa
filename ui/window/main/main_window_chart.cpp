// The main window's friction curve: its menu, and how it follows the session.
#include <QFileInfo>
#include <QMenu>

#include "ui/chart/chart_view.h"
#include "ui/window/accuracy/accuracy_panel.h"
#include "ui/window/curve/curve_commands.h"
#include "ui/window/curve/curve_comparison.h"
#include "ui/window/curve/curve_display.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/session.h"
#include "ui/window/main/status_line.h"

namespace asperity {

namespace {

constexpr int kOnePlot = 170, kTwoPlots = 300;  // least heights, pixels

}  // namespace

/// Called when menus, views and session are there.
void MainWindow::buildChartCommands(QMenu& menu) {
  const auto run = [this](std::function<void()> work, std::function<void()> done) {
    runExport(std::move(work), std::move(done));
  };
  curveCommands_ = new CurveCommands(*session_, *plot_, run, parts_);
  curveCommands_->fill(menu);
  addActions(menu.actions());  // keys work where the menu bar is hidden, too
  connect(curveCommands_, &CurveCommands::exported, this, [this](const QString& file) {
    status_->say(file.isEmpty() ? tr("The curve's picture is on the clipboard")
                                : tr("Saved %1").arg(QFileInfo(file).fileName()));
    emit exported(file);
  });
}

void MainWindow::connectChart() {
  plot_->setFocusPolicy(Qt::StrongFocus);
  connect(session_, &Session::plotChanged, this, &MainWindow::showMeasuredCurve);
  auto* display = new CurveDisplay(*session_, *plot_, parts_);
  connect(display, &CurveDisplay::sceneEdited, this,
          [this](const Scene& scene) { editScene(scene, QT_TR_NOOP("Velocity")); });
  auto* comparison = new CurveComparison(*session_, parts_);
  connect(accuracy_, &AccuracyPanel::comparisonChanged, this, [this, comparison] {
    comparison->setSetting(accuracy_->comparison());
    // Two plots need more room than one.
    plot_->setMinimumHeight(accuracy_->comparison() ? kTwoPlots : kOnePlot);
  });
  connect(comparison, &CurveComparison::failed, this, [this](const QString& reason) {
    messages_->showFailure(MessageBar::Failure::Comparison, reason);
  });
  connect(comparison, &CurveComparison::shown, this,
          [this] { endFailure(MessageBar::Failure::Comparison); });
}

}  // namespace asperity
