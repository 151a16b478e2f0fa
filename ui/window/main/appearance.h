// The window's colours: everything is derived from the picture's Theme, so that contact view, chart
// and controls belong together; and which theme there is, light, dark or as the system has it.
// GUI thread. Cannot fail.
#pragma once

#include <QColor>
#include <QObject>
#include <QPalette>
#include <QSizeF>
#include <QString>

#include "ui/contact/contact_picture.h"
#include "ui/draw/text_painter.h"

class QMenu;
class QWidget;

namespace asperity {

class Commands;

enum class Colours { System, Light, Dark };

class Appearance : public QObject {
  Q_OBJECT

 public:
  explicit Appearance(QWidget& window);

  void addTo(Commands& commands);
  /// A submenu: same as system, light, dark.
  void addMenu(QMenu& menu);

  /// Chooses the colours of the system, or always light or dark ones.
  void setColours(Colours colours);
  Colours colours() const { return colours_; }

  /// Sets palette and style sheet anew, also where only the font has changed.
  void setDark(bool dark);
  bool isDark() const { return isDark_; }
  const Theme& theme() const;

 signals:
  void themeChanged(const asperity::Theme& theme);

 private:
  QWidget& window_;
  Commands* commands_ = nullptr;
  QList<QAction*> choices_;  // one for each of Colours
  Colours colours_ = Colours::System;
  bool isDark_ = false;
};

bool isDark(const Theme& theme);

/// Whether the desktop's own colours are dark, as found at the first call: before setPalette().
bool systemIsDark();
QPalette paletteOf(const Theme& theme);

/// How much larger all texts are in a presentation on a screen of this size in pixels: read from
/// the back of a room, they keep their share of a large one.
double presentedScale(const QSizeF& screen);

/// Returns the style sheet of the main window: bars, docks, menus, splitter, message bar.
QString windowStyleSheet(const Theme& theme);

}  // namespace asperity
