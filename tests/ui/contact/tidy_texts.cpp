#include "tests/ui/contact/tidy_texts.h"

#include <gtest/gtest.h>

#include <QFontMetricsF>
#include <QTransform>
#include <QtMath>
#include <vector>

#include "ui/draw/fonts.h"

namespace asperity {

std::string allTexts(const DrawList& list) {
  std::string words;
  for (const DrawText& text : list.texts) words += text.utf8 + "|";
  return words;
}

QRectF inkOf(const DrawText& text) {
  const QFontMetricsF metrics(toQFont(text));
  const QString words = QString::fromStdString(text.utf8);
  const qreal advance = metrics.horizontalAdvance(words);
  const qreal left = text.anchor == TextAnchor::Left     ? 0
                     : text.anchor == TextAnchor::Centre ? -advance / 2
                                                         : -advance;
  const QRectF ink = metrics.tightBoundingRect(words).translated(left, 0);
  QTransform turn;
  turn.translate(text.x, text.y);
  turn.rotate(-qRadiansToDegrees(static_cast<qreal>(text.angle)));
  return turn.mapRect(ink);
}

void expectTidy(const DrawList& list, const std::string& where) {
  const QRectF picture(0, 0, list.width, list.height);
  std::vector<QRectF> boxes;
  for (const DrawText& text : list.texts) boxes.push_back(inkOf(text));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_TRUE(picture.contains(boxes[i])) << where << ": " << list.texts[i].utf8;
    for (std::size_t k = 0; k < i; ++k) {
      const QRectF common = boxes[i].intersected(boxes[k]);
      EXPECT_FALSE(common.width() > 0.5 && common.height() > 0.5)
          << where << ": " << list.texts[i].utf8 << " over " << list.texts[k].utf8;
    }
  }
}

}  // namespace asperity
