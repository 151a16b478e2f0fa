// Texts of a DrawList by QPainter, and whole pictures as QImage. Needs a QGuiApplication (the
// offscreen platform will do); fonts come from the program itself. Main thread for fonts' loading.
#pragma once

#include <QImage>

#include "ui/render/draw_list.h"

class QPainter;

namespace asperity {

class OsmesaContext;

/// Adds the fonts in resources/fonts or the system's DejaVu to the application; once is enough.
void loadFonts();

/// Paints list.texts; the painter's coordinates are the list's pixels.
void paintTexts(QPainter& painter, const DrawList& list);

/// Shapes and texts as one picture.
QImage renderImage(OsmesaContext& context, const DrawList& list);

}  // namespace asperity
