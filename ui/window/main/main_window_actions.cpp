// The main window's commands: actions with their keys, menus, tool bar, dialogs.
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <string>
#include <utility>

#include "ui/language/translated.h"
#include "ui/panels/number_text.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/command_words.h"
#include "ui/window/main/main_window.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/mnemonics.h"
#include "ui/window/main/scene_document.h"
#include "ui/window/main/scene_library.h"
#include "ui/window/main/session.h"
#include "ui/window/main/window_language.h"

namespace asperity {

void MainWindow::buildActions() {
  play_ = addCommand("play", tr("Pause"), Qt::Key_Space, Symbol::Pause,
                     [this] { session_->setPlaying(!session_->isPlaying()); });
  step_ = addCommand("step", tr("Step"), Qt::Key_Period, Symbol::Step,
                     [this] { session_->singleStep(partPerStep()); });
  reset_ =
      addCommand("reset", tr("Reset"), Qt::Key_R, Symbol::Reset, [this] { session_->reset(); });
  buildFileCommands();
  buildEditCommands();
  buildCopyCommands();
  light_ = addCommand("light", tr("Dark colours"), {}, Symbol::Light,
                      [this] { setColours(dark_ ? Colours::Light : Colours::Dark); });
  buildLayoutCommands();
  buildHelpCommands();
  buildFigures();
  buildMenus();
  buildToolBar();
}

QAction* MainWindow::addCommand(const char* name, const QString& text, const QKeySequence& key,
                                Symbol symbol, std::function<void()> run) {
  auto* action = new QAction(parts_);
  action->setObjectName(name);
  action->setShortcut(key);
  setCommandText(*action, text);
  action->setData(static_cast<int>(symbol));
  connect(action, &QAction::triggered, this, std::move(run));
  addAction(action);
  return action;
}

void MainWindow::buildMenus() {
  fillFiles(*menuBar()->addMenu(tr("&File")));
  fillEdit(*menuBar()->addMenu(tr("&Edit")));

  scenes_ = menuBar()->addMenu(tr("&Scenes"));
  fillScenes(*scenes_);

  fillFigures(*menuBar()->addMenu(tr("Fi&gures")));

  QMenu* run = menuBar()->addMenu(tr("&Run"));
  run->addActions({play_, step_, reset_});

  QMenu* view = menuBar()->addMenu(tr("&View"));
  buildViewCommands(*view);
  view->addSeparator();
  fillLayout(*view);
  view->addSeparator();
  // Later: the menu that was chosen from goes.
  addLanguages(*view, [this] {
    QMetaObject::invokeMethod(
        this, [this] { setLanguage(windowLanguage()); }, Qt::QueuedConnection);
  });

  buildChartCommands(*menuBar()->addMenu(tr("&Curve")));

  fillHelp(*menuBar()->addMenu(tr("&Help")));
  for (QAction* action : menuBar()->actions()) adoptActions(*action->menu());
  for (QMenu* menu : menuBar()->findChildren<QMenu*>()) keepMnemonics(*menu);
}

/// Their keys are the window's, too: they go on where the menu bar is hidden.
void MainWindow::adoptActions(QMenu& menu) {
  for (QAction* action : menu.actions()) {
    if (action->menu())
      adoptActions(*action->menu());
    else if (!action->shortcut().isEmpty())
      addAction(action);
  }
}

/// A submenu for each chapter; what has none stands in the menu itself.
void MainWindow::fillScenes(QMenu& menu) {
  std::string chapter;
  QMenu* part = &menu;
  for (const LibraryScene& entry : libraryScenes()) {
    if (entry.scene.chapter != chapter) {
      chapter = entry.scene.chapter;
      part = chapter.empty() ? &menu : menu.addMenu(sceneText(chapter));
      part->setToolTipsVisible(true);
    }
    const QString title = sceneText(entry.scene.title);
    QAction* action = part->addAction(title.isEmpty() ? entry.name : title, this, [this, entry] {
      replaceScene({entry.name, {}, entry.scene});
    });
    action->setToolTip(wrappedTip(sceneText(entry.scene.description)));
    action->setObjectName("scene:" + entry.name);
  }
}

void MainWindow::buildToolBar() {
  QToolBar* bar = addToolBar(tr("Commands"));
  tools_ = bar;
  bar->setObjectName("commands");
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->addActions({play_, step_, reset_});
  bar->addSeparator();

  auto* scenes = new QToolButton;
  scenes->setText(buttonText(tr("Scenes")));
  scenes->setObjectName("scenesButton");
  scenes->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  scenes->setPopupMode(QToolButton::InstantPopup);
  scenes->setMenu(scenes_);
  bar->addWidget(scenes);
  bar->addActions({figures_, open_, save_});
  bar->addSeparator();
  bar->addActions({undo_, redo_});

  auto* space = new QWidget;
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  bar->addAction(light_);
  for (QAction* action : {undo_, redo_, light_})
    if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action)))
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);

  // What has no room is behind this button. Its own arrow is black and lost in the style sheet.
  if (auto* more = bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))) {
    more->setToolButtonStyle(Qt::ToolButtonTextOnly);
    more->setText(QStringLiteral("»"));
    more->setToolTip(tr("More commands"));
    more->setAccessibleName(tr("More commands"));
  }
}

void MainWindow::showPlaying(bool playing) {
  setCommandText(*play_, playing ? tr("Pause") : tr("Play"));
  play_->setData(static_cast<int>(playing ? Symbol::Pause : Symbol::Play));
  paintIcons();
}

void MainWindow::paintIcons() {
  const QColor colour = paletteOf(dark_ ? darkTheme() : lightTheme()).color(QPalette::WindowText);
  for (QAction* action : {play_, step_, reset_, figures_, open_, save_, undo_, redo_, light_}) {
    action->setIcon(symbolIcon(static_cast<Symbol>(action->data().toInt()), colour));
    action->setIconVisibleInMenu(false);
  }
  if (auto* scenes = findChild<QToolButton*>("scenesButton"))
    scenes->setIcon(symbolIcon(Symbol::Scenes, colour));
  setCommandText(*light_, dark_ ? tr("Light colours") : tr("Dark colours"));
}

}  // namespace asperity
