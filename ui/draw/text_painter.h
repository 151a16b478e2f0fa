// Texts of a DrawList by QPainter, and whole pictures as QImage. Needs a QGuiApplication (the
// offscreen platform will do); fonts come from the program itself. Main thread for fonts' loading.
#pragma once

#include <QColor>
#include <QFont>
#include <QImage>

#include "ui/draw/draw_list.h"

class QPainter;

namespace asperity {

class PixelContext;

/// Adds the embedded fonts (resources/fonts) to the application; once is enough. Throws
/// std::runtime_error if Qt refuses them.
void loadFonts();

QColor colourOf(const Rgba& colour);

/// The font that paints this text.
QFont fontOf(const DrawText& text);

/// Paints list.texts; the painter's coordinates are the list's pixels.
void paintTexts(QPainter& painter, const DrawList& list);

/// Shapes and texts as one picture. Throws std::runtime_error where the context cannot draw.
QImage renderImage(PixelContext& context, const DrawList& list);

}  // namespace asperity
