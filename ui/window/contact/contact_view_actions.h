// The contact view's commands, for a menu, its context menu and their keys: zoom, exaggeration,
// following the line, the magnifier, what is coloured. They belong to the canvas and follow it.
// GUI thread.
#pragma once

#include <QList>

class QAction;
class QMenu;

namespace asperity {

class ContactCanvas;

/// Adds them to the canvas and to the menu; called once.
void addContactViewActions(ContactCanvas& canvas, QMenu& menu);

}  // namespace asperity
