// The main window's commands: actions with their keys, menus, tool bar, dialogs.
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QToolBar>
#include <QToolButton>
#include <string>
#include <utility>

#include "ui/panels/number_text.h"
#include "ui/window/appearance.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_library.h"
#include "ui/window/session.h"

namespace asperity {

namespace {

/// On buttons without dots, and with air between icon and text.
QString buttonText(QString text) {
  return QChar(0x2002) + text.remove(u'…');
}

/// Rich text is broken into lines where plain text is not.
QString wrappedTip(const QString& text) {
  return text.isEmpty() ? QString() : "<p>" + text.toHtmlEscaped() + "</p>";
}

void setCommandText(QAction& action, const QString& text) {
  action.setText(text);
  action.setIconText(buttonText(text));
  action.setToolTip(action.shortcut().isEmpty()
                        ? text
                        : QStringLiteral("%1 (%2)").arg(
                              text, action.shortcut().toString(QKeySequence::NativeText)));
}

}  // namespace

void MainWindow::buildActions() {
  play_ = addCommand("play", tr("Pause"), Qt::Key_Space, Symbol::Pause,
                     [this] { session_->setPlaying(!session_->isPlaying()); });
  step_ = addCommand("step", tr("Step"), Qt::Key_Period, Symbol::Step,
                     [this] { session_->singleStep(); });
  reset_ =
      addCommand("reset", tr("Reset"), Qt::Key_R, Symbol::Reset, [this] { session_->reset(); });
  open_ = addCommand("open", tr("Open scene…"), QKeySequence::Open, Symbol::Open,
                     [this] { askOpen(); });
  save_ = addCommand("save", tr("Save scene…"), QKeySequence::Save, Symbol::Save,
                     [this] { askSave(); });
  light_ = addCommand("light", tr("Dark colours"), {}, Symbol::Light, [this] { setDark(!dark_); });
  buildFigures();
  buildMenus();
  buildToolBar();
}

QAction* MainWindow::addCommand(const char* name, const QString& text, const QKeySequence& key,
                                Symbol symbol, std::function<void()> run) {
  auto* action = new QAction(this);
  action->setObjectName(name);
  action->setShortcut(key);
  setCommandText(*action, text);
  action->setData(static_cast<int>(symbol));
  connect(action, &QAction::triggered, this, std::move(run));
  addAction(action);
  return action;
}

void MainWindow::buildMenus() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  file->addActions({open_, save_});
  file->addSeparator();
  file->addAction(tr("Quit"), QKeySequence::Quit, this, &QWidget::close);

  scenes_ = menuBar()->addMenu(tr("&Scenes"));
  fillScenes(*scenes_);

  fillFigures(*menuBar()->addMenu(tr("Fi&gures")));

  QMenu* run = menuBar()->addMenu(tr("&Run"));
  run->addActions({play_, step_, reset_});

  QMenu* view = menuBar()->addMenu(tr("&View"));
  buildViewCommands(*view);
  view->addSeparator();
  view->addAction(dock_->toggleViewAction());
  view->addAction(light_);

  buildChartCommands(*menuBar()->addMenu(tr("&Curve")));

  menuBar()->addMenu(tr("&Help"))->addAction(tr("About Asperity"), this, &MainWindow::showAbout);
}

/// A submenu for each chapter; what has none stands in the menu itself.
void MainWindow::fillScenes(QMenu& menu) {
  std::string chapter;
  QMenu* part = &menu;
  for (const LibraryScene& entry : libraryScenes()) {
    if (entry.scene.chapter != chapter) {
      chapter = entry.scene.chapter;
      part = chapter.empty() ? &menu : menu.addMenu(fromUtf8(chapter));
      part->setToolTipsVisible(true);
    }
    const QString title = QString::fromStdString(entry.scene.title);
    QAction* action = part->addAction(title.isEmpty() ? entry.name : title, this,
                                      [this, scene = entry.scene] { showScene(scene); });
    action->setToolTip(wrappedTip(fromUtf8(entry.scene.description)));
    action->setObjectName("scene:" + entry.name);
  }
}

void MainWindow::buildToolBar() {
  QToolBar* bar = addToolBar(tr("Commands"));
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

  auto* space = new QWidget;
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  bar->addAction(light_);
  if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(light_)))
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
}

void MainWindow::showPlaying(bool playing) {
  setCommandText(*play_, playing ? tr("Pause") : tr("Play"));
  play_->setData(static_cast<int>(playing ? Symbol::Pause : Symbol::Play));
  paintIcons();
}

void MainWindow::paintIcons() {
  const QColor colour = paletteOf(dark_ ? darkTheme() : lightTheme()).color(QPalette::WindowText);
  for (QAction* action : {play_, step_, reset_, figures_, open_, save_, light_}) {
    action->setIcon(symbolIcon(static_cast<Symbol>(action->data().toInt()), colour));
    action->setIconVisibleInMenu(false);
  }
  if (auto* scenes = findChild<QToolButton*>("scenesButton"))
    scenes->setIcon(symbolIcon(Symbol::Scenes, colour));
  setCommandText(*light_, dark_ ? tr("Light colours") : tr("Dark colours"));
}

void MainWindow::showAbout() {
  auto* box = new QMessageBox(this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowTitle(tr("About Asperity"));
  box->setText(tr("<h3>Asperity %1</h3>").arg(ASPERITY_VERSION));
  box->setInformativeText(
      tr("Shows how a viscoelastic elastomer slides over a randomly rough rigid line, after Li et "
         "al., <i>Friction between a viscoelastic body and a rigid surface with random self-affine "
         "roughness</i>, Physical Review Letters 111, 034301 (2013).<br><br>The elements of the "
         "elastomer are independent of each other: long-range elastic coupling is not in the "
         "model.<br><br>Free software, GPL-3.0-or-later."));
  box->open();
}

}  // namespace asperity
