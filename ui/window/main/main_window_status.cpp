// The main window's status bar: how it follows the session.
#include <QStatusBar>
#include <QTimer>
#include <QUndoStack>

#include "ui/window/main/contact_canvas.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/session.h"
#include "ui/window/main/status_line.h"

namespace asperity {

namespace {

constexpr int kDrawingInterval = 500;  // ms
constexpr int kWorkInterval = 100;

}  // namespace

void MainWindow::buildStatus() {
  status_ = new StatusLine;
  statusBar()->addWidget(status_, 1);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->setContentsMargins(0, 0, 0, 0);
  auto* drawing = new QTimer(parts_);
  connect(drawing, &QTimer::timeout, this,
          [this] { status_->showDrawing(canvas_->framesPerSecond(), canvas_->backendName()); });
  drawing->start(kDrawingInterval);
  auto* work = new QTimer(parts_);
  connect(work, &QTimer::timeout, this, &MainWindow::showWork);
  work->start(kWorkInterval);
  connect(status_, &StatusLine::stopWanted, session_, &Session::stopCurve);
  connect(status_, &StatusLine::againWanted, this, [this] {
    curveTime_.start();
    session_->startCurve();
  });
  connect(status_, &StatusLine::backWanted, this, [this] { document_->history().undo(); });
}

void MainWindow::showWork() {
  Work work;
  work.simulationsPerSecond = session_->simulationsPerSecond();
  work.progress = session_->friction().progress();
  if (session_->isWaiting())
    work.state = Work::State::Waiting;
  else if (session_->averaging() == Session::Averaging::Running)
    work.state = Work::State::Running;
  else if (session_->averaging() == Session::Averaging::Stopped)
    work.state = Work::State::Stopped;
  status_->showWork(work);
}

}  // namespace asperity
