// Faults that keep a person from reading or reaching what a window shows: texts that are cut off or
// name the key of a scene file, widgets that lie over each other or beyond their window, windows
// that are larger than the screen, and controls that the Tab key does not reach. For tests on the
// GUI thread.
#pragma once

#include <QSize>
#include <QStringList>

class QWidget;

namespace asperity {

/// Returns the faults of what is visible in the window, one a line, once its layout has settled. A
/// text may be shortened where its tooltip has the whole of it; parts that are scrolled out of
/// sight count as readable.
QStringList readingFaults(QWidget& window);

/// Returns the controls of the active window that the Tab key does not reach, those that keep it,
/// and those that it reaches but that have no name for screen readers. A button may do without the
/// key where its tooltip names another one: "Close (Esc)".
QStringList tabFaults(QWidget& window);

/// Returns whether a screen reader says more of a control than its kind and its value.
bool hasSpokenName(QWidget& widget);

/// Returns why the window with its frame does not fit on a screen of this size; empty where it
/// does.
QStringList sizeFaults(const QWidget& window, QSize screen);

}  // namespace asperity
