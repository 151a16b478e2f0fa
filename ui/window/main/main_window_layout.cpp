// The main window's layout: docks, tabs, full screen, presentation, colours, and how they are kept
// from one start to the next.
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <QToolBar>
#include <algorithm>
#include <utility>

#include "ui/window/main/appearance.h"
#include "ui/window/main/command_words.h"
#include "ui/window/main/contact_canvas.h"
#include "ui/window/main/main_window.h"

namespace asperity {

namespace {

constexpr int kLayoutVersion = 1;  // of docks and tool bars

/// What a window manager draws around a window at most, usually: it tells only when the window is
/// shown.
constexpr QMargins kFrame{8, 40, 8, 8};

const QList<int>& defaultSplit() {
  static const QList<int> sizes{580, 420};
  return sizes;
}

/// Settings outlive versions: a tab is kept by its name, not by its place.
QString tabName(const QTabWidget& tabs, int index) {
  return tabs.widget(index)->objectName();
}

}  // namespace

void MainWindow::buildLayoutCommands() {
  fullScreen_ = addCommand("fullScreen", tr("Full screen"), Qt::Key_F11, Symbol::None,
                           [this] { setFullScreen(!isFullScreen()); });
  present_ = addCommand("present", tr("Presentation"), Qt::Key_F5, Symbol::None,
                        [this] { setPresenting(!isPresenting()); });
  for (QAction* action : {fullScreen_, present_}) action->setCheckable(true);
  leave_ = addCommand("leave", tr("Leave full screen"), Qt::Key_Escape, Symbol::None,
                      [this] { leaveFullScreen(); });
  leave_->setEnabled(false);
  restoreLayout_ = addCommand("restoreLayout", tr("Restore layout"), {}, Symbol::None,
                              [this] { restoreDefaultLayout(); });
  QAction* parameters = dock_->toggleViewAction();
  parameters->setObjectName("parameters");
  parameters->setShortcut(Qt::Key_F9);
  addAction(parameters);
}

void MainWindow::fillLayout(QMenu& menu) {
  menu.addAction(dock_->toggleViewAction());
  fillTabs(*menu.addMenu(tr("Tabs")));
  menu.addSeparator();
  menu.addActions({fullScreen_, present_, leave_});
  menu.addSeparator();
  fillColours(*menu.addMenu(tr("Colours")));
  menu.addAction(restoreLayout_);
}

/// Which tabs there are, each with a key that brings it to the front. The motion's tab comes and
/// goes with the scene.
void MainWindow::fillTabs(QMenu& menu) {
  for (int i = 0; i < tabs_->count(); ++i) {
    QAction* action = menu.addAction(tabs_->tabText(i));
    action->setObjectName("tab:" + tabName(*tabs_, i));
    action->setCheckable(true);
    action->setChecked(true);
    connect(action, &QAction::toggled, this, [this, i](bool on) {
      tabs_->setTabVisible(i, on && tabActions_.at(i)->isVisible());
      const auto isOn = [](const QAction* each) { return each->isVisible() && each->isChecked(); };
      tabs_->setVisible(std::ranges::any_of(tabActions_, isOn));
    });
    tabActions_ += action;
    action->setVisible(tabs_->widget(i)->objectName() != "transientStrips");
    auto* go = addCommand(
        qPrintable("go:" + tabName(*tabs_, i)), tr("Show %1").arg(tabs_->tabText(i)),
        Qt::ALT | static_cast<Qt::Key>(Qt::Key_1 + i), Symbol::None, [this, i] { showTab(i); });
    go->setProperty("group", tr("Tabs"));
  }
}

void MainWindow::showTab(int index) {
  QAction* action = tabActions_.at(index);
  if (action->isVisible()) action->setChecked(true);
  if (tabs_->isTabVisible(index)) tabs_->setCurrentIndex(index);
}

void MainWindow::fillColours(QMenu& menu) {
  auto* group = new QActionGroup(parts_);
  const QStringList texts{tr("As the desktop"), tr("Light"), tr("Dark")};
  for (int i = 0; i < texts.size(); ++i) {
    QAction* action =
        menu.addAction(texts[i], this, [this, i] { setColours(static_cast<Colours>(i)); });
    action->setObjectName(QStringLiteral("colours:%1").arg(i));
    action->setCheckable(true);
    group->addAction(action);
    colourActions_ += action;
  }
}

void MainWindow::setColours(Colours colours) {
  colours_ = colours;
  colourActions_.at(static_cast<int>(colours))->setChecked(true);
  const bool dark = colours == Colours::System ? systemIsDark() : colours == Colours::Dark;
  if (dark != dark_ || styleSheet().isEmpty()) setDark(dark);  // which is a third of the start
}

void MainWindow::setFullScreen(bool full) {
  full ? showFullScreen() : showNormal();
  showScreenMode();
}

void MainWindow::leaveFullScreen() {
  isPresenting() ? setPresenting(false) : setFullScreen(false);
}

void MainWindow::showScreenMode() {
  fullScreen_->setChecked(isFullScreen());
  present_->setChecked(isPresenting());
  leave_->setEnabled((isFullScreen() || isPresenting()) && !isShowingFigures());
}

/// The page of figures stays: what stands around it is of the views, and changes behind it.
void MainWindow::setPresenting(bool presenting) {
  if (presenting == isPresenting()) return showScreenMode();
  const bool hadFigures = isShowingFigures();
  closeFigures();
  presenting ? beginPresentation() : endPresentation();
  if (hadFigures) openFigures();
  showScreenMode();
}

void MainWindow::beginPresentation() {
  presentation_ = {
      QApplication::font(),    saveGeometry(), saveState(kLayoutVersion), dock_->size(), {},
      !statusBar()->isHidden()};
  for (QSplitter* splitter : findChildren<QSplitter*>())
    presentation_->splits.emplaceBack(splitter, splitter->saveState());
  const double scale = presentedScale(screen()->size());
  QFont large = presentation_->font;
  large.setPointSizeF(large.pointSizeF() * scale);
  QApplication::setFont(large);
  canvas_->setTextScale(scale);
  for (QWidget* around : std::initializer_list<QWidget*>{menuBar(), tools_, statusBar(), dock_})
    around->hide();
  setDark(dark_);  // what was painted with the other font
  setFullScreen(true);
}

void MainWindow::endPresentation() {
  const Presentation before = *std::exchange(presentation_, std::nullopt);
  QApplication::setFont(before.font);
  canvas_->setTextScale(1);
  menuBar()->show();
  statusBar()->setVisible(before.hasStatus);
  setDark(dark_);
  restoreGeometry(before.geometry);
  restoreState(before.docks, kLayoutVersion);
  for (const auto& [splitter, sizes] : before.splits)
    if (splitter) splitter->restoreState(sizes);
  // Again, when the layouts have seen that the letters are small: until then what they need at
  // least squeezes the dock.
  QTimer::singleShot(0, parts_, [this, size = before.dock] {
    if (isPresenting()) return;
    resizeDocks({dock_}, {size.width()}, Qt::Horizontal);
    resizeDocks({dock_}, {size.height()}, Qt::Vertical);
  });
}

void MainWindow::restoreDefaultLayout() {
  restoreState(defaultLayout_);
  splitter_->setSizes(defaultSplit());
  for (QAction* action : std::as_const(tabActions_)) action->setChecked(true);
}

void MainWindow::rememberLayout() {
  remembers_ = true;
  QSettings settings;
  settings.beginGroup("window");
  restoreGeometry(settings.value("geometry").toByteArray());
  fitToScreen();
  restoreState(settings.value("docks").toByteArray(), kLayoutVersion);
  splitter_->restoreState(settings.value("split").toByteArray());
  const QStringList hidden = settings.value("hiddenTabs").toStringList();
  for (int i = 0; i < tabActions_.size(); ++i)
    if (hidden.contains(tabName(*tabs_, i))) tabActions_[i]->setChecked(false);
  setColours(static_cast<Colours>(std::clamp(settings.value("colours", 0).toInt(), 0, 2)));
  showScreenMode();
}

/// With its frame.
void MainWindow::fitToScreen() {
  const Qt::WindowStates state = windowState();
  const QRect wanted = state == Qt::WindowNoState ? geometry() : normalGeometry();
  const bool hasPlace = testAttribute(Qt::WA_Moved);
  const QScreen* there = hasPlace ? QGuiApplication::screenAt(wanted.center()) : nullptr;
  const QRect room = (there ? there : screen())->availableGeometry().marginsRemoved(kFrame);
  setMinimumSize(kLeastWindow.boundedTo(room.size()));
  const QSize size = wanted.size().boundedTo(room.size());
  const QRect fitted(std::clamp(wanted.x(), room.left(), room.right() + 1 - size.width()),
                     std::clamp(wanted.y(), room.top(), room.bottom() + 1 - size.height()),
                     size.width(), size.height());
  if (fitted == wanted) return;
  setWindowState(Qt::WindowNoState);
  hasPlace ? setGeometry(fitted) : resize(size);
  setWindowState(state);
}

/// As it is without the figures and without an audience.
void MainWindow::saveLayout() {
  const std::optional<Presentation> before = presentation_;
  setPresenting(false);
  closeFigures();
  QStringList hidden;
  for (int i = 0; i < tabActions_.size(); ++i)
    if (!tabActions_[i]->isChecked()) hidden += tabName(*tabs_, i);
  QSettings settings;
  settings.beginGroup("window");
  settings.setValue("geometry", before ? before->geometry : saveGeometry());
  settings.setValue("docks", before ? before->docks : saveState(kLayoutVersion));
  settings.setValue("split", splitter_->saveState());
  settings.setValue("hiddenTabs", hidden);
  settings.setValue("colours", static_cast<int>(colours_));
}

}  // namespace asperity
