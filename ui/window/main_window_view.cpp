// The main window's contact view: its part of the View menu, and how it follows the session.
#include <QMenu>

#include "ui/window/contact_canvas.h"
#include "ui/window/contact_view_actions.h"
#include "ui/window/main_window.h"
#include "ui/window/message_bar.h"
#include "ui/window/session.h"

namespace asperity {

/// Called once, when menus, views and session are there. What it adds stands first in the View
/// menu.
void MainWindow::buildViewCommands(QMenu& menu) {
  menu.setToolTipsVisible(true);
  addContactViewActions(*canvas_, menu);
}

void MainWindow::connectView() {
  connect(canvas_, &ContactCanvas::failed, messages_, &MessageBar::showMessage);
  connect(canvas_, &ContactCanvas::fieldsWanted, session_, &Session::wantFields);
}

}  // namespace asperity
