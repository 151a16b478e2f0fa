// How commands are written in menus, on buttons and in tooltips. GUI thread.
#pragma once

#include <QString>

class QAction;

namespace asperity {

/// On buttons without dots, and with air between icon and text.
QString buttonText(QString text);

/// Rich text is broken into lines where plain text is not.
QString wrappedTip(const QString& text);

/// Menu, button and tooltip with the key.
void setCommandText(QAction& action, const QString& text);

}  // namespace asperity
