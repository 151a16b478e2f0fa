// The look of the window: its colours, style sheet and style. All colours are derived from the
// picture's Theme, so that contact view, chart and controls match. The user chooses the theme:
// light, dark or the system's. GUI thread. Cannot fail.
#pragma once

#include <QColor>
#include <QObject>
#include <QPalette>
#include <QProxyStyle>
#include <QSizeF>
#include <QString>

#include "ui/contact/contact_picture.h"
#include "ui/draw/fonts.h"

class QMenu;
class QWidget;

namespace asperity {

class Commands;

enum class Colours { System, Light, Dark };

class Appearance : public QObject {
  Q_OBJECT

 public:
  /// Sets the palette of the application and the style sheet of the window. This is done before the
  /// window has children: Qt evaluates both again for each of them.
  explicit Appearance(QWidget& window);

  void addTo(Commands& commands);
  /// Adds a submenu: same as system, light, dark.
  void addMenu(QMenu& menu);

  /// Chooses the colours of the system, or always light or dark ones.
  void setColours(Colours colours);
  Colours colours() const { return colours_; }

  /// Sets palette and style sheet again, also where only the font has changed.
  void setDark(bool dark);
  /// Passes the theme on to the commands, and to all parts by themeChanged.
  void announceTheme();
  bool isDark() const { return isDark_; }
  const Theme& theme() const;

 signals:
  void themeChanged(const asperity::Theme& theme);

 private:
  void applyTheme();

  QWidget& window_;
  Commands* commands_ = nullptr;
  QList<QAction*> choices_;  // one for each value of Colours
  Colours colours_ = Colours::System;
  bool isDark_ = false;
};

/// Qt's Fusion style with visible check boxes, sliders and borders of entries in the dark theme,
/// where Fusion draws them black on black.
class WindowStyle : public QProxyStyle {
 public:
  WindowStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override;
  QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                       const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                          QPainter* painter, const QWidget* widget) const override;
};

/// Returns whether the desktop's own colours are dark, read at the first call, before setPalette().
bool systemIsDark();
QPalette themePalette(const Theme& theme);

/// Returns the factor of all texts in a presentation on a screen of this size in pixels. It keeps
/// the size of texts relative to a large screen, so that they can be read from the back of a room.
double presentationScale(const QSizeF& screen);

/// Returns the style sheet of the main window: bars, docks, menus, splitter, message bar.
QString windowStyleSheet(const Theme& theme);

}  // namespace asperity
