// The look of the window: its colours and its style sheet. All colours are derived from the
// picture's Theme, so that contact view, chart and controls match. The user chooses the theme:
// light, dark or the system's. GUI thread. Cannot fail.
#pragma once

#include <QColor>
#include <QList>
#include <QObject>
#include <QPalette>
#include <QSizeF>
#include <QString>

#include "core/base/named_choices.h"
#include "ui/draw/fonts.h"
#include "ui/draw/theme.h"

class QAction;
class QMenu;
class QWidget;

namespace asperity {

class Commands;

/// The theme that the user chose.
enum class ThemeChoice { System, Light, Dark };

/// The choices by their words in the settings.
inline constexpr NamedChoices<ThemeChoice, 3> kThemeChoices{
    {{"system", ThemeChoice::System}, {"light", ThemeChoice::Light}, {"dark", ThemeChoice::Dark}}};

class Appearance : public QObject {
  Q_OBJECT

 public:
  /// Sets the palette of the application and the style sheet of the window. This is done before the
  /// window has children: Qt evaluates both again for each of them.
  explicit Appearance(QWidget& window);

  void addTo(Commands& commands);
  /// Adds a submenu: same as system, light, dark.
  void addMenu(QMenu& menu);

  /// Follows the theme of the system, or always uses the light or the dark one.
  void chooseTheme(ThemeChoice choice);
  ThemeChoice themeChoice() const { return choice_; }

  /// Sets palette and style sheet again, also where only the font has changed.
  void setDark(bool dark);
  /// Passes the theme on to the commands, and to all parts by themeChanged.
  void announceTheme();
  bool isDark() const { return isDark_; }
  bool eventFilter(QObject* watched, QEvent* event) override;
  const Theme& theme() const;

 signals:
  void themeChanged(const asperity::Theme& theme);
  /// Emitted by chooseTheme(), also where the theme stays.
  void themeChosen();

 private:
  void applyTheme();

  QWidget& window_;
  Commands* commands_ = nullptr;
  QList<QAction*> choices_;  // one for each value of ThemeChoice
  ThemeChoice choice_ = ThemeChoice::System;
  bool isSystemDark_ = false, isDark_ = false;
};

/// Returns whether the desktop's own colours are dark. Of the themes of Qt 6.4, that of KDE knows
/// them and reports their change; those of GNOME are always light.
bool systemIsDark();
QPalette themePalette(const Theme& theme);
/// Returns the theme of pictures in windows of this palette, light or dark.
const Theme& pictureTheme(const QPalette& palette);

/// Returns the factor of all texts in a presentation on a screen of this size in pixels. Texts are
/// the same part of the height of every screen, so that they can be read from the back of a room,
/// and a small screen keeps its space for the pictures.
double presentationScale(const QSizeF& screen);

/// Returns the style sheet of the main window: bars, docks, menus, splitter, message bar.
QString windowStyleSheet(const Theme& theme);

}  // namespace asperity
