// The main window's friction curve: its menu, and how it follows the session.
#include <QMenu>
#include <QTimer>

#include "ui/charts/plot_view.h"
#include "ui/window/main_window.h"
#include "ui/window/session.h"

namespace asperity {

namespace {

constexpr int kPlotPause = 80;  // ms; painting a diagram costs as much as several pictures

}  // namespace

/// Called once, when menus, views and session are there.
void MainWindow::buildChartCommands(QMenu& menu) {
  menu.menuAction()->setVisible(!menu.isEmpty());
}

void MainWindow::connectChart() {
  connect(session_, &Session::plotChanged, this, &MainWindow::showMeasuredCurve);
  plotPause_ = new QTimer(this);
  plotPause_->setSingleShot(true);
  plotPause_->setInterval(kPlotPause);
  connect(plotPause_, &QTimer::timeout, this, [this] {
    if (plotIsDue_) showPlot();
  });
  connect(session_, &Session::plotChanged, this, &MainWindow::showPlotSoon);
  showPlot();
}

void MainWindow::showPlotSoon() {
  if (plotPause_->isActive())
    plotIsDue_ = true;
  else
    showPlot();
}

void MainWindow::showPlot() {
  plotIsDue_ = false;
  plot_->setPlot(session_->plot());
  plotPause_->start();
}

}  // namespace asperity
