#include "ui/draw/text_painter.h"

#include <QColor>
#include <QFont>
#include <QFontDatabase>
#include <QFontMetricsF>
#include <QPainter>
#include <QtMath>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "ui/draw/font_subset.h"
#include "ui/draw/pixel_context.h"

namespace asperity {
namespace {

qreal leftEnd(const DrawText& text, qreal advance) {
  if (text.anchor == TextAnchor::Centre) return -advance / 2;
  return text.anchor == TextAnchor::Right ? -advance : 0;
}

void paintText(QPainter& painter, const DrawText& text) {
  const QFont font = fontOf(text);
  const QString words = QString::fromStdString(text.utf8);
  painter.save();
  painter.translate(text.x, text.y);
  if (text.angle != 0) painter.rotate(-qRadiansToDegrees(static_cast<qreal>(text.angle)));
  painter.setFont(font);
  painter.setPen(colourOf(text.colour));
  qreal left = leftEnd(text, QFontMetricsF(font).horizontalAdvance(words));
  if (text.angle == 0) left = std::round(text.x + left) - text.x;  // whole pixels: sharp stems
  painter.drawText(QPointF(left, 0), words);
  painter.restore();
}

}  // namespace

void loadFonts() {
  static const bool loaded = [] {
    for (const bool bold : {false, true})
      if (QFontDatabase::addApplicationFontFromData(fontFile(bold)) < 0)
        throw std::runtime_error("The embedded font DejaVu Sans cannot be loaded.");
    return true;
  }();
  static_cast<void>(loaded);
}

QColor colourOf(const Rgba& c) {
  return QColor::fromRgbF(c.r, c.g, c.b, c.a);
}

QFont fontOf(const DrawText& text) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(std::max(1, qRound(text.size)));
  font.setBold(text.bold);
  font.setKerning(false);  // as textWidth() measures
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

void paintTexts(QPainter& painter, const DrawList& list) {
  painter.save();
  painter.setRenderHint(QPainter::TextAntialiasing);
  for (const DrawText& text : list.texts) paintText(painter, text);
  painter.restore();
}

QImage renderImage(PixelContext& context, const DrawList& list) {
  // The image takes the pixels over instead of copying them.
  auto* pixels = new Pixels(context.draw(list));
  QImage image(
      pixels->rgba.data(), pixels->width, pixels->height, qsizetype{4} * pixels->width,
      QImage::Format_RGBA8888_Premultiplied, [](void* p) { delete static_cast<Pixels*>(p); },
      pixels);
  QPainter painter(&image);
  paintTexts(painter, list);
  painter.end();
  return image;
}

}  // namespace asperity
