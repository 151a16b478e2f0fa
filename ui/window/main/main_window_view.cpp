// The main window's contact view: its part of the View menu, and how it follows the session.
#include <QMenu>

#include "core/run/line_diagrams.h"
#include "ui/window/main/contact_canvas.h"
#include "ui/window/main/contact_view_actions.h"
#include "ui/window/figures/diagram_view.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/session.h"

namespace asperity {

/// Called when menus, views and session are there. What it adds stands first in the View
/// menu.
void MainWindow::buildViewCommands(QMenu& menu) {
  menu.setToolTipsVisible(true);
  addContactViewActions(*canvas_, menu);
}

void MainWindow::connectView() {
  connect(canvas_, &ContactCanvas::failed, messages_, &MessageBar::showMessage);
  connect(canvas_, &ContactCanvas::fieldsWanted, this, &MainWindow::wantFields);
  connect(statistics_, &DiagramView::visibilityChanged, this, &MainWindow::wantFields);
  connect(session_, &Session::waitingChanged, this, [this](bool waits) {
    canvas_->setVeil(waits ? tr("This is the scene before; the changed one is being computed")
                           : QString());
  });
  connect(session_, &Session::frameArrived, this, [this] {
    if (statistics_->isVisible())
      statistics_->show([frame = session_->frame()] { return statisticsSheet(*frame); });
  });
}

/// Of the period, so that a step by hand can be seen: a part of what is in view.
double MainWindow::partPerStep() const {
  constexpr double kOfView = 1.0 / 200;
  const Frame* frame = canvas_->frame();
  if (!frame || !(frame->length > 0)) return kOfView;
  return kOfView * canvas_->viewer().options().view.width / frame->length;
}

/// What the contact shows and what the statistics count, and no more.
void MainWindow::wantFields() {
  FrameFields fields = canvas_->fields();
  fields.lineSlope = fields.lineSlope || statistics_->isVisible();
  session_->wantFields(fields);
}

}  // namespace asperity
