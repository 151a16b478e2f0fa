#include "ui/window/main/window_layout.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <algorithm>
#include <string>

#include "ui/panels/controls.h"
#include "ui/panels/panel_style.h"
#include "ui/panels/parameter_panel.h"
#include "ui/window/contact/contact_canvas.h"
#include "ui/window/gallery/scene_gallery.h"
#include "ui/window/main/appearance.h"
#include "ui/window/main/commands.h"
#include "ui/window/main/message_bar.h"
#include "ui/window/main/scene_tabs.h"
#include "ui/window/main/window_pages.h"

namespace asperity {

namespace {

constexpr int kBorderStep = 24;    // pixels
constexpr int kLow = 800;          // pixels, of a screen or window whose views are low
constexpr int kLayoutVersion = 1;  // version of the layout of docks and tool bars

/// The largest usual frame of a window manager around a window; the true frame is known only when
/// the window is shown.
constexpr QMargins kFrame{8, 40, 8, 8};

const QString kColours = QStringLiteral("window/colours");

/// Reads the word of the choice, or its number, as which it was saved earlier.
ThemeChoice savedTheme() {
  const std::string word = QSettings().value(kColours).toString().toStdString();
  for (std::size_t i = 0; i < kThemeChoices.size(); ++i)
    if (word == std::to_string(i)) return kThemeChoices[i].second;
  return findChoice(kThemeChoices, word).value_or(ThemeChoice::System);
}

const QList<int>& defaultSplit() {
  static const QList<int> sizes{600, 400};
  return sizes;
}

QString panelNote() {
  return WindowLayout::tr("F9 shows the parameters; Esc ends the presentation.");
}

}  // namespace

WindowLayout::WindowLayout(const LayoutParts& parts) : QObject(&parts.window), parts_(parts) {
  parts_.splitter.setSizes(defaultSplit());
  fitDescription();
  for (QObject* watched : std::initializer_list<QObject*>{&parts_.offer, &parts_.window})
    watched->installEventFilter(this);
  connect(&parts_.pages, &WindowPages::pageChanged, this, &WindowLayout::hideDocks);
  connect(&parts_.dock, &QDockWidget::visibilityChanged, this, [this](bool isVisible) {
    if (isVisible) endPanelNote();
  });
  connect(&parts_.appearance, &Appearance::themeChosen, this, &WindowLayout::saveTheme);
}

WindowLayout::~WindowLayout() {
  if (presentation_) QApplication::setFont(presentation_->font);  // for other windows, too
}

/// Leaves the height of a low window to the contact: the description of the scene has one line
/// where the offer of the tour stands above it, or letters are large, and otherwise two.
void WindowLayout::fitDescription() {
  const int height =
      isPresenting() ? parts_.window.screen()->size().height() : parts_.window.height();
  const bool isCrowded = isPresenting() || !parts_.offer.isHidden();
  parts_.description.setLineLimit(isCrowded && height < kLow ? 1 : 2);
}

bool WindowLayout::eventFilter(QObject* watched, QEvent* event) {
  const bool isOfOffer =
      watched == &parts_.offer && (event->type() == QEvent::Show || event->type() == QEvent::Hide);
  if (isOfOffer || (watched == &parts_.window && event->type() == QEvent::Resize)) fitDescription();
  return QObject::eventFilter(watched, event);
}

void WindowLayout::addTo(Commands& commands) {
  commands_ = &commands;
  commands.add({"fullScreen",
                [] { return tr("Full screen"); },
                [this] { setFullScreen(!parts_.window.isFullScreen()); },
                {Qt::Key_F11}});
  commands.add({"present",
                [] { return tr("Presentation"); },
                [this] { setPresenting(!isPresenting()); },
                {Qt::Key_F5}});
  for (QAction* action : commands.get({"fullScreen", "present"})) action->setCheckable(true);
  const auto leave = [this] {
    if (isPresenting())
      setPresenting(false);
    else
      setFullScreen(false);
  };
  commands.add({"leave", [] { return tr("Leave full screen"); }, leave, {Qt::Key_Escape}})
      ->setEnabled(false);
  commands.add(
      {"restoreLayout", [] { return tr("Restore layout"); }, [this] { restoreDefault(); }});
  commands.add({"borderDown",
                [] { return tr("More height for the contact"); },
                [this] { moveBorder(kBorderStep); },
                {Qt::CTRL | Qt::ALT | Qt::Key_Down}});
  commands.add({"borderUp",
                [] { return tr("More height for the chart"); },
                [this] { moveBorder(-kBorderStep); },
                {Qt::CTRL | Qt::ALT | Qt::Key_Up}});
  commands.add({"filterParameters",
                [] { return tr("Search parameters"); },
                [this] { filterParameters(); },
                {Qt::Key_Slash}});
  QAction* parameters = parts_.dock.toggleViewAction();
  parameters->setObjectName("parameters");
  parameters->setShortcut(Qt::Key_F9);
  parts_.window.addAction(parameters);
}

void WindowLayout::fillMenu(QMenu& menu) {
  menu.addAction(parts_.dock.toggleViewAction());
  menu.addAction(commands_->get("filterParameters"));
  parts_.tabs.addMenu(menu);
  menu.addActions(commands_->get({"borderDown", "borderUp"}));
  menu.addSeparator();
  menu.addActions(commands_->get({"fullScreen", "present", "leave"}));
  menu.addSeparator();
  parts_.appearance.addMenu(menu);
  menu.addAction(commands_->get("restoreLayout"));
}

/// The gallery of scenes has a filter of its own, which the key then means.
void WindowLayout::filterParameters() {
  if (parts_.pages.isShowingFigures()) return;
  if (parts_.pages.isShowingGallery()) return parts_.pages.gallery().focusFilter();
  parts_.dock.show();
  parts_.dock.raise();
  parts_.panel.focusFilter();
}

/// Moves the border between contact and tabs, as far as both have their minimum heights.
void WindowLayout::moveBorder(int down) {
  const QList<int> sizes = parts_.splitter.sizes();
  parts_.splitter.setSizes({sizes[0] + down, sizes[1] - down});
}

void WindowLayout::setFullScreen(bool full) {
  if (full)
    parts_.window.showFullScreen();
  else
    parts_.window.showNormal();
  showScreenMode();
}

/// While another page covers the views, Escape closes that page instead of the presentation.
void WindowLayout::showScreenMode() {
  const bool isFull = parts_.window.isFullScreen();
  commands_->get("fullScreen")->setChecked(isFull);
  commands_->get("present")->setChecked(isPresenting());
  commands_->get("leave")->setEnabled((isFull || isPresenting()) && parts_.pages.isShowingViews());
}

/// Hides the parameters and readings of the contact while another page covers the views.
void WindowLayout::hideDocks(bool areViewsCovered) {
  QStatusBar& status = *parts_.window.statusBar();
  if (areViewsCovered) {
    hadDock_ = !parts_.dock.isHidden();
    hadStatus_ = !status.isHidden();
  }
  parts_.dock.setVisible(!areViewsCovered && hadDock_);
  status.setVisible(!areViewsCovered && hadStatus_);
  showScreenMode();
}

// ---- Presentation

/// Begins or ends the presentation. The page of figures stays; the parts around it belong to the
/// views.
void WindowLayout::setPresenting(bool presenting) {
  if (presenting == isPresenting()) return showScreenMode();
  const bool hadFigures = parts_.pages.isShowingFigures();
  parts_.pages.showViews();
  const bool hidesPanel = presenting && !hadFigures && !parts_.dock.isHidden();
  if (presenting)
    beginPresentation();
  else
    endPresentation();
  if (hidesPanel) showPanelNote();
  if (hadFigures) parts_.pages.openFigures();
  showScreenMode();
}

void WindowLayout::beginPresentation() {
  QMainWindow& window = parts_.window;
  presentation_ = {QApplication::font(),
                   window.saveGeometry(),
                   window.saveState(kLayoutVersion),
                   dockSize_.value_or(parts_.dock.size()),
                   {},
                   !window.statusBar()->isHidden()};
  for (QSplitter* splitter : window.findChildren<QSplitter*>())
    presentation_->splits.emplaceBack(splitter, splitter->saveState());
  const double scale = presentationScale(window.screen()->size());
  QFont large = presentation_->font;
  large.setPointSizeF(large.pointSizeF() * scale);
  QApplication::setFont(large);
  parts_.canvas.setTextScale(scale);
  parts_.tabs.setMayScroll(true);
  for (QToolBar* bar : window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) bar->hide();
  for (QWidget* around : Widgets{window.menuBar(), window.statusBar(), &parts_.dock})
    around->hide();
  // The style sheet is set again for what was painted with the other font.
  parts_.appearance.setDark(parts_.appearance.isDark());
  // On a low screen large letters around the chart leave it little height.
  if (window.screen()->size().height() < kLow) parts_.splitter.setSizes({540, 460});
  fitDescription();
  setFullScreen(true);
}

/// Shows for a while how the parameters come back, which the presentation has hidden.
void WindowLayout::showPanelNote() {
  constexpr int kShown = 8000;              // milliseconds
  if (!parts_.messages.isHidden()) return;  // an error matters more
  hasPanelNote_ = true;
  parts_.messages.showNote(panelNote);
  QTimer::singleShot(kShown, this, &WindowLayout::endPanelNote);
}

void WindowLayout::endPanelNote() {
  const bool hadNote = std::exchange(hasPanelNote_, false);
  if (hadNote && parts_.messages.text() == panelNote()) parts_.messages.hide();
}

void WindowLayout::endPresentation() {
  endPanelNote();
  QMainWindow& window = parts_.window;
  const Presentation before = *std::exchange(presentation_, std::nullopt);
  QApplication::setFont(before.font);
  parts_.canvas.setTextScale(1);
  fitDescription();
  parts_.tabs.setMayScroll(false);
  window.menuBar()->show();
  window.statusBar()->setVisible(before.hasStatus);
  parts_.appearance.setDark(parts_.appearance.isDark());
  window.restoreGeometry(before.geometry);
  restoreDocks(before.docks, kLayoutVersion);
  for (const auto& [splitter, sizes] : before.splits)
    if (splitter) splitter->restoreState(sizes);
  // The size of the dock is restored after the layouts have handled the smaller letters: until then
  // minimum sizes limit it.
  dockSize_ = before.dock;
  QTimer::singleShot(0, this, [this] {
    if (isPresenting() || !dockSize_) return;
    const QSize size = *std::exchange(dockSize_, std::nullopt);
    parts_.window.resizeDocks({&parts_.dock}, {size.width()}, Qt::Horizontal);
    parts_.window.resizeDocks({&parts_.dock}, {size.height()}, Qt::Vertical);
  });
}

// ---- Settings between starts

/// Restores places and sizes. The panel of a lesson is shown by the lesson alone: a state that was
/// saved during one must not bring back a panel without a lesson, nor close the one that runs.
bool WindowLayout::restoreDocks(const QByteArray& state, int version) {
  std::vector<std::pair<QDockWidget*, bool>> shown;
  for (auto* dock : parts_.window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
    if (dock != &parts_.dock) shown.emplace_back(dock, !dock->isHidden());
  const bool isRestored = parts_.window.restoreState(state, version);
  for (const auto& [dock, isShown] : shown) dock->setVisible(isShown);
  return isRestored;
}

void WindowLayout::keepAsDefault() {
  default_ = parts_.window.saveState();
}

void WindowLayout::restoreDefault() {
  restoreDocks(default_);
  parts_.splitter.setSizes(defaultSplit());
  parts_.tabs.hideTabs({});
  parts_.panel.setView(ParameterPanel::defaultView());
}

void WindowLayout::remember() {
  QSettings settings;
  settings.beginGroup("window");
  parts_.window.restoreGeometry(settings.value("geometry").toByteArray());
  fitToScreen();
  if (!restoreDocks(settings.value("docks").toByteArray(), kLayoutVersion)) fitDockToScreen();
  parts_.splitter.restoreState(settings.value("split").toByteArray());
  parts_.tabs.hideTabs(settings.value("hiddenTabs").toStringList());
  const PanelView usual = ParameterPanel::defaultView();
  parts_.panel.setView({settings.value("showsAllParameters", usual.showsAll).toBool(),
                        settings.value("foldedSections", usual.folded).toStringList()});
  parts_.appearance.chooseTheme(savedTheme());
  remembers_ = true;
  showScreenMode();
}

/// On a small screen the parameters take only the width that they need.
void WindowLayout::fitDockToScreen() {
  constexpr int kSmall = 1200;  // pixels
  const int width = parts_.window.width() < kSmall ? parts_.panel.minimumWidth()
                                                   : parts_.panel.sizeHint().width();
  parts_.window.resizeDocks({&parts_.dock}, {width}, Qt::Horizontal);
}

/// Saves the layout as it is without the figures and without a presentation.
void WindowLayout::save() {
  if (!remembers_) return;
  const std::optional<Presentation> before = presentation_;
  setPresenting(false);
  parts_.pages.showViews();
  QSettings settings;
  settings.beginGroup("window");
  settings.setValue("geometry", before ? before->geometry : parts_.window.saveGeometry());
  settings.setValue("docks", before ? before->docks : parts_.window.saveState(kLayoutVersion));
  settings.setValue("split", parts_.splitter.saveState());
  settings.setValue("hiddenTabs", parts_.tabs.hiddenTabs());
  const PanelView panel = parts_.panel.view();
  settings.setValue("showsAllParameters", panel.showsAll);
  settings.setValue("foldedSections", panel.folded);
}

/// Saves the colours as soon as they are chosen: the program may end in another way than by closing
/// the window.
void WindowLayout::saveTheme() {
  if (!remembers_) return;
  QSettings().setValue(kColours,
                       fromUtf8(choiceWord(kThemeChoices, parts_.appearance.themeChoice())));
}

/// Fits the window, including its frame, to the screen.
void WindowLayout::fitToScreen() {
  QMainWindow& window = parts_.window;
  const Qt::WindowStates state = window.windowState();
  const QRect requested = state == Qt::WindowNoState ? window.geometry() : window.normalGeometry();
  const bool hasPlace = window.testAttribute(Qt::WA_Moved);
  const QScreen* screen = hasPlace ? QGuiApplication::screenAt(requested.center()) : nullptr;
  if (!screen) screen = window.screen();
  const QRect available = screen->availableGeometry().marginsRemoved(kFrame);
  window.setMinimumSize(kMinWindowSize.boundedTo(available.size()));
  const QSize size = requested.size().boundedTo(available.size());
  const QRect fitted(
      std::clamp(requested.x(), available.left(), available.right() + 1 - size.width()),
      std::clamp(requested.y(), available.top(), available.bottom() + 1 - size.height()),
      size.width(), size.height());
  if (fitted == requested) return;
  window.setWindowState(Qt::WindowNoState);
  if (hasPlace)
    window.setGeometry(fitted);
  else
    window.resize(size);
  window.setWindowState(state);
}

namespace {

/// Returns the size of the screen on which a page over a window appears.
QSize screenSize(const QWidget& page) {
  const QWidget& window = page.parentWidget() ? *page.parentWidget() : page;
  return window.screen()->availableSize();
}

}  // namespace

void resizePage(QWidget& page, QSize usual) {
  constexpr double kScreenShare = 0.7;  // of a large screen
  const QSize available = screenSize(page);
  page.resize(usual.expandedTo(kScreenShare * available).boundedTo(available - kWindowFrame));
}

void resizeDialog(QWidget& dialog, QSize usual) {
  constexpr int kFree = 60;  // pixels of the screen around it
  dialog.resize(usual.boundedTo(screenSize(dialog) - QSize(kFree, kFree)));
}

}  // namespace asperity
