// The window's colours: everything is derived from the picture's Theme, so that contact view, chart
// and controls belong together. Pure functions; GUI thread.
#pragma once

#include <QColor>
#include <QPalette>
#include <QSizeF>
#include <QString>

#include "ui/contact/contact_picture.h"
#include "ui/draw/text_painter.h"

namespace asperity {

bool isDark(const Theme& theme);

/// Whether the desktop's own colours are dark, as found at the first call: before setPalette().
bool systemIsDark();
QPalette paletteOf(const Theme& theme);

/// How much larger all texts are in a presentation on a screen of this size in pixels: read from
/// the back of a room, they keep their share of a large one.
double presentedScale(const QSizeF& screen);

/// For the main window: bars, docks, menus, splitter, message bar.
QString windowStyleSheet(const Theme& theme);

}  // namespace asperity
