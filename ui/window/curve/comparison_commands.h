// The commands for comparisons beside the friction curve: theories and measured tables, each by its
// name in a menu, and the page that fits the scene to the tables. Every choice is a step of the
// document. Object names: "theory:WORD", "measured:NUMBER", "measuredMenu", "theoryMenu",
// "fitParameters", "fitButton". Owned by the main window; GUI thread. Failure: errors appear on the
// page of the fit, others as in ImportCommands.
#pragma once

#include <QObject>
#include <functional>

#include "core/scene/scene.h"
#include "ui/window/fit/fit_choices.h"

class QAction;
class QMenu;
class QToolButton;
class QWidget;

namespace asperity {

class Commands;
class FitPage;
struct Fit;
class SceneDocument;
class SceneTabs;

class ComparisonCommands : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    QWidget& window;
    SceneDocument& document;
    SceneTabs& tabs;
    /// Opens a file dialog for a measured table; returns whether one was added.
    std::function<bool()> addTable;
  };
  explicit ComparisonCommands(const Parts& parts);

  /// Adds the command that opens the page; its button stands over the friction curve while there is
  /// measured friction.
  void addTo(Commands& commands);
  /// Adds the submenus of theories and tables, and the command.
  void fill(QMenu& menu, Commands& commands);

  /// Shows the page of the fit. Opens a file dialog for a table first where the scene names none.
  FitPage* openFit();

 private:
  void fillTables();
  void showScene(const Scene& scene);
  void takeTheory(Theory theory, bool isSelected);
  void removeTable(std::size_t index);
  void takeValues(const Fit& fit);

  Parts parts_;
  FitSelection selection_;  // of the last fit
  QToolButton* button_;
  QMenu *theories_ = nullptr, *tables_ = nullptr;
};

}  // namespace asperity
