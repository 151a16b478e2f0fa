// Every state of the pages and dialogs that import, fit, export and show figures, one after the
// other, as a person brings them about: for pictures that are looked at, and for tests of what can
// be read in them. GUI thread.
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace asperity {

class MainWindow;

struct DialogWishes {
  QString program;  // that export dialogs run
  QSize screen{1024,
               700};   // of the screen, on which dialogs have the size that they give themselves
  QStringList only{};  // beginnings of names; empty: all states
  QString moduli{};    // isotherms of a real rubber; empty: few made ones
  QStringList surfaces{};  // further measured surfaces
  bool hasFigures = true;  // whether the figures of the paper are computed, each with few lines
};

/// Called with a name such as "surface_trend" and the dialog or the part of the main window.
using StateVisit = std::function<void(const QString& name, QWidget& shown)>;

/// Brings about each state and visits it. The window is left with a scene of its own.
void visitDialogs(MainWindow& window, const DialogWishes& wishes, const StateVisit& visit);

}  // namespace asperity
