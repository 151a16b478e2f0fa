// The contact view's commands, for a menu, its context menu and their keys: zoom, exaggeration,
// following the line, the magnifier, the quantity shown by colours. They belong to the canvas and
// show its state. GUI thread.
#pragma once

#include <QList>

class QAction;
class QMenu;

namespace asperity {

class ContactCanvas;

/// Adds the commands to the canvas and to the menu; call it once.
void addContactViewActions(ContactCanvas& canvas, QMenu& menu);

}  // namespace asperity
