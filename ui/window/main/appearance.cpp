#include "ui/window/main/appearance.h"

#include <QActionGroup>
#include <QApplication>
#include <QEvent>
#include <QMenu>
#include <QWidget>
#include <algorithm>

#include "ui/draw/fonts.h"
#include "ui/language/language.h"
#include "ui/panels/controls.h"
#include "ui/panels/panel_style.h"
#include "ui/window/main/commands.h"

namespace asperity {

namespace {

/// The rules for the bars, menus, tabs and docks of a window.
const QString kWindowRules = QStringLiteral(R"(
    QMainWindow, QStatusBar, QToolBar, QMenuBar, QDockWidget { background: @window; color: @text; }
    QMainWindow::separator { background: @edge; width: 1px; height: 1px; }
    QMenuBar { padding: 2px 6px; border: none; }
    QMenuBar::item { padding: 4px 9px; border-radius: 5px; background: transparent; }
    QMenuBar::item:selected { background: @hovered; }
    QMenu { background: @window; color: @text; border: 1px solid @edge; padding: 5px; }
    QMenu::item { padding: 5px 26px 5px 14px; border-radius: 4px; }
    QMenu::item:selected { background: @hovered; }
    QMenu::item:disabled { color: @faint; }
    QMenu::separator { height: 1px; background: @edge; margin: 5px 8px; }
    QToolBar { border: none; border-bottom: 1px solid @edge; padding: 2px 8px 5px 8px; spacing: 4px; }
    QToolBar::separator { background: @edge; width: 1px; margin: 5px 6px; }
    QToolBar QToolButton { border: none; border-radius: 6px; padding: 5px 8px; color: @text; }
    QToolBar QToolButton:disabled { color: @faint; }
    QToolBar QToolButton:hover { background: @hovered; }
    QToolBar QToolButton:pressed { background: @edge; }
    QToolBar QToolButton:checked { background: @hovered; }
    QToolBar QToolButton::menu-indicator { image: none; }
    QToolBar #qt_toolbar_ext_button { padding: 0; border-radius: 3px; }
    QStatusBar { border-top: 1px solid @edge; }
    QStatusBar::item { border: none; }
    QStatusBar QLabel:disabled, QStatusBar QToolButton:disabled { color: @faint; }
    QSplitter::handle { background: @edge; }
    QSplitter::handle:hover { background: @accent; }
    #messageBar { background: @alert; border: none; }
    #messageBar QLabel { color: @onAlert; }
    #messageBar QToolButton { border: none; color: @onAlert; }
    #messageBar[note="true"] { background: @tint; border-bottom: 1px solid @edge; }
    #messageBar[note="true"] QLabel { color: @text; }
    #messageBar[note="true"] QToolButton { color: @faint; }
    #shortcutKeys { border: 1px solid @edge; border-radius: 4px; padding: 1px 6px; color: @text; }
    #descriptionBar { background: @window; border: none; border-bottom: 1px solid @edge; }
    #descriptionBar QLabel { color: @text; }
    #descriptionBar QToolButton { border: none; color: @faint; }
    #descriptionBar #moreOfMessage { color: @accent; }
    #hintBar, #tourBar { background: @tint; border: none; border-bottom: 1px solid @edge; }
    #hintBar QLabel, #tourBar QLabel { color: @text; }
    #hintBar QToolButton { border: none; color: @faint; }
    #hintBar QPushButton, #tourBar QPushButton { border: 1px solid @edge; border-radius: 5px;
      background: @window; color: @text; padding: 3px 12px; }
    #hintBar QPushButton:hover, #tourBar QPushButton:hover,
    #hintBar QPushButton:focus, #tourBar QPushButton:focus { border-color: @accent; }
    #tourBar QPushButton:disabled { color: @faint; }
    QTabWidget::pane { border: none; }
    QTabWidget QTabBar::tab { background: transparent; color: @faint; padding: 6px 14px; border: none;
      border-bottom: 2px solid transparent; }
    QTabWidget QTabBar[crowded="1"]::tab { padding: 6px 7px; }
    QTabWidget QTabBar[crowded="2"]::tab { padding: 6px 4px; }
    QTabWidget QTabBar::tab:hover { color: @text; }
    QTabWidget QTabBar::tab:disabled { color: @edge; }
    QTabWidget QTabBar::tab:selected { color: @text; border-bottom: 2px solid @accent; }
    #fitButton { border: none; border-radius: 5px; margin: 4px 8px 4px 4px; padding: 3px 10px;
      background: @hovered; color: @text; }
    #fitButton:hover { background: @edge; }
    #fitButton:focus { border: 1px solid @accent; padding: 2px 9px; }
    #fitKeys QHeaderView::section, #planList QHeaderView::section { background: @window; color: @faint; border: none; padding: 4px 6px; }
    #planList QHeaderView::section { padding: 4px 3px; }
    #planList { padding-left: 11px; background: @view; }
    #planList::item:disabled { color: @faint; }
    #regionPictures { background: @view; }
    #regionBar QLabel { color: @faint; }
    #regionBar QToolButton { border: none; border-radius: 5px; padding: 2px 9px; color: @faint; }
    #regionBar QToolButton:hover { background: @hovered; color: @text; }
    #regionBar QToolButton:checked { background: @hovered; color: @text; }
    #regionBar QToolButton:focus { border: 1px solid @accent; padding: 1px 8px; }
    #dockTitle { background: @window; border-bottom: 1px solid @edge; }
    #dockTitle QLabel { color: @faint; }
    #dockTitle #lessonTitle { color: @text; }
    #dockTitle QToolButton { border: none; border-radius: 4px; color: @faint; padding: 2px 6px; }
    #dockTitle QToolButton:hover { background: @hovered; color: @text; }
    #dockTitle QToolButton[role="framed"] { border: 1px solid @edge; color: @text; }
    #dockTitle QToolButton[role="framed"]:focus { border-color: @accent; }
    QToolTip { background: @window; color: @text; border: 1px solid @edge; padding: 3px; }
    QScrollBar:vertical { background: transparent; width: 9px; margin: 0; }
    QScrollBar::handle:vertical { background: @edge; border-radius: 4px; min-height: 30px; }
    QScrollBar:horizontal { background: transparent; height: 9px; margin: 0; }
    QScrollBar::handle:horizontal { background: @edge; border-radius: 4px; min-width: 30px; }
    QScrollBar::handle:disabled { background: transparent; }
    QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
    QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
  )");

/// Returns the colour of everything that can be dragged; it is legible on the panels of both
/// themes.
QColor accentColour(const Theme& theme) {
  return isDark(theme) ? QColor(0x6c, 0xb2, 0xff) : QColor(0x1f, 0x6f, 0xc9);
}

/// Returns the colour of bars and docks; in the dark theme they are a little lighter than the
/// views.
QColor panelColour(const Theme& theme) {
  return isDark(theme) ? mixed(toQColor(theme.background), Qt::white, 0.06) : toQColor(theme.panel);
}

QColor edgeColour(const Theme& theme) {
  return mixed(panelColour(theme), toQColor(theme.text), isDark(theme) ? 0.22 : 0.18);
}

}  // namespace

/// Reads a role that themePalette() leaves to the desktop.
bool systemIsDark() {
  return QApplication::palette().color(QPalette::Midlight).lightness() < 128;
}

const Theme& pictureTheme(const QPalette& palette) {
  return isDark(palette) ? darkTheme() : lightTheme();
}

QPalette themePalette(const Theme& theme) {
  const QColor panel = panelColour(theme);
  const QColor text = toQColor(theme.text);
  const QColor base = isDark(theme) ? toQColor(theme.background) : QColor(Qt::white);
  QPalette palette;
  palette.setColor(QPalette::Window, panel);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, mixed(base, text, 0.05));
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::Button, mixed(panel, text, 0.06));
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::PlaceholderText, toQColor(theme.faintText));
  palette.setColor(QPalette::Highlight, accentColour(theme));
  palette.setColor(QPalette::HighlightedText,
                   isDark(theme) ? QColor(Qt::black) : QColor(Qt::white));
  palette.setColor(QPalette::Link, accentColour(theme));
  palette.setColor(QPalette::Mid, edgeColour(theme));
  palette.setColor(QPalette::Dark, edgeColour(theme));
  palette.setColor(QPalette::Light, mixed(panel, base, 0.5));
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, mixed(panel, text, 0.45));
  return palette;
}

double presentationScale(const QSizeF& screen) {
  constexpr double kUsual = 1.5, kMin = 1.1;
  constexpr double kHeight = 900, kWidth = 1300;  // pixels that the usual scale needs
  return std::max(kMin, kUsual * std::min(screen.width() / kWidth, screen.height() / kHeight));
}

QString windowStyleSheet(const Theme& theme) {
  const QPalette palette = themePalette(theme);
  const QColor panel = panelColour(theme);
  const bool dark = isDark(theme);
  return styleSheet(kWindowRules, palette,
                    {{"hovered", mixed(panel, toQColor(theme.text), 0.1).name()},
                     {"tint", mixed(panel, accentColour(theme), 0.12).name()},
                     {"alert", dark ? "#5b2a2a" : "#fde3e1"},
                     {"onAlert", dark ? "#ffd9d6" : "#8c1d18"},
                     {"view", toQColor(theme.background).name()}}) +
         messageStyleSheet(palette);
}

Appearance::Appearance(QWidget& window)
    : QObject(&window), window_(window), isSystemDark_(systemIsDark()), isDark_(isSystemDark_) {
  applyTheme();
  window.installEventFilter(this);
}

/// Follows the desktop, also where the user chooses its colours later.
bool Appearance::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ApplicationPaletteChange && systemIsDark() != isSystemDark_) {
    isSystemDark_ = !isSystemDark_;
    chooseTheme(choice_);
  }
  return QObject::eventFilter(watched, event);
}

void Appearance::addTo(Commands& commands) {
  commands_ = &commands;
  commands.add({"light",
                [this] { return isDark_ ? tr("Light colours") : tr("Dark colours"); },
                [this] { chooseTheme(isDark_ ? ThemeChoice::Light : ThemeChoice::Dark); },
                {},
                Symbol::Light});
}

void Appearance::addMenu(QMenu& menu) {
  QMenu* themes = addSubmenu(menu, {}, [] { return tr("Theme"); });
  auto* group = new QActionGroup(this);
  for (const ThemeChoice choice : {ThemeChoice::System, ThemeChoice::Light, ThemeChoice::Dark}) {
    choices_ += checkedEntry(*themes, QStringLiteral("colours:%1").arg(static_cast<int>(choice)),
                             {}, choice == choice_, [this, choice](bool) { chooseTheme(choice); });
    group->addAction(choices_.last());
  }
  keepTranslated(*themes, [this] {
    choices_[0]->setText(tr("Same as system"));
    choices_[1]->setText(tr("Light"));
    choices_[2]->setText(tr("Dark"));
  });
}

void Appearance::chooseTheme(ThemeChoice choice) {
  choice_ = choice;
  if (!choices_.isEmpty()) choices_.at(static_cast<int>(choice))->setChecked(true);
  const bool dark = choice == ThemeChoice::System ? isSystemDark_ : choice == ThemeChoice::Dark;
  if (dark != isDark_) setDark(dark);
  emit themeChosen();
}

void Appearance::setDark(bool dark) {
  isDark_ = dark;
  applyTheme();
  announceTheme();
}

void Appearance::applyTheme() {
  QApplication::setPalette(themePalette(theme()));
  window_.setStyleSheet(windowStyleSheet(theme()));
}

void Appearance::announceTheme() {
  commands_->setColour(themePalette(theme()).color(QPalette::WindowText));
  commands_->refresh("light");
  emit themeChanged(theme());
}

const Theme& Appearance::theme() const {
  return isDark_ ? darkTheme() : lightTheme();
}

}  // namespace asperity
