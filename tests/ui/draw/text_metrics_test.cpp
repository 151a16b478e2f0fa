#include "ui/draw/fonts.h"
#include "ui/draw/shapes.h"

#include <gtest/gtest.h>

#include <QFontMetricsF>

namespace asperity {
namespace {

TEST(TextMetrics, AgreeWithThePaintedFont) {
  for (const char* words :
       {"rigid line slides", "v = \u2212100 mm/s", "2.3\u00D710\u207B\u2075 \u00B5m",
        "coefficient of friction \u03BC", "\u03C4 = 1 ms, 13.1 %", "\u2013 \u2026",
        "\u03B1 \u03B2 \u0394 \u2207z \u221D \u221A2 \u2264 \u221E",
        "\u00B1 \u00BD m\u00B2 \u00B0 \u00FC"}) {
    for (const float size : {9.0F, 12.0F, 31.0F}) {
      for (const bool bold : {false, true}) {
        DrawText text;
        text.utf8 = words;
        text.size = size;
        text.bold = bold;
        const double painted =
            QFontMetricsF(toQFont(text)).horizontalAdvance(QString::fromUtf8(words));
        EXPECT_GT(textWidth(words, size, bold), painted - 0.02 * size) << words << " " << size;
        // Ligatures ("ffi") are a little narrower than their letters.
        EXPECT_LT(textWidth(words, size, bold), painted + 0.15 * size) << words << " " << size;
      }
    }
  }
}

TEST(TextMetrics, ElisionFitsAndKeepsCharactersWhole) {
  const std::string title = "Gr\u00FCne Stra\u00DFe \u2013 a very long title";
  EXPECT_EQ(elided(title, 12, true, 1000), title);
  for (float width = 0; width < 200; width += 3) {
    const std::string shorter = elided(title, 12, true, width);
    EXPECT_LE(textWidth(shorter, 12, true), width);
    EXPECT_FALSE(QString::fromStdString(shorter).contains(QChar::ReplacementCharacter));
  }
  EXPECT_EQ(elided(title, 12, true, 5), "");
}

TEST(TextMetrics, WrappingKeepsEveryWordWhereThereIsRoom) {
  const std::string words = "one two three four five six seven eight nine ten";
  for (float width = 60; width < 400; width += 7) {
    std::string together;
    for (const std::string& line : wrapped(words, 12, false, width)) {
      EXPECT_LE(textWidth(line, 12), width);
      together += (together.empty() ? "" : " ") + line;
    }
    EXPECT_EQ(together, words);
  }
  EXPECT_EQ(wrapped("a\nb", 12, false, 500).size(), 2U);
  EXPECT_TRUE(wrapped("", 12, false, 500).empty());
}

TEST(TextMetrics, DamagedTextIsMeasuredAllTheSame) {
  EXPECT_GT(textWidth("\xFF\xC3", 10), 0);
  EXPECT_GT(textWidth("\xF0\x9F", 10), 0);
  EXPECT_EQ(textWidth("", 10), 0);
}

/// As in a subtitle or a legend, beside numbers that may be infinite.
TEST(TextMetrics, TheEquilibriumModulusHasALoweredSign) {
  DrawList list;
  addLabel(list, "H = 0.7, G\u221E = 1 MPa, F\u2099 = \u221E", {20, 100}, 12, TextAnchor::Left, {});
  std::vector<std::string> lowered, usual;
  for (const DrawText& text : list.texts)
    (text.y > list.texts[0].y ? lowered : usual).push_back(text.utf8);
  EXPECT_EQ(lowered, (std::vector<std::string>{"\u221E", "N"}));
  EXPECT_EQ(usual, (std::vector<std::string>{"H = 0.7, G", " = 1 MPa, F", " = \u221E"}));
  // The letter is smaller, too; the sign would not be readable then.
  EXPECT_EQ(list.texts[1].size, 12);
  EXPECT_LT(list.texts[3].size, 12);
}

/// As the title of an axis: read from below, its pieces lie above each other.
TEST(TextMetrics, AnUprightLabelHasALoweredN) {
  DrawList list;
  constexpr float kUpright = 1.57079633F;
  addLabel(list, "normal force F\u2099 (N)", {20, 100}, 12, TextAnchor::Centre, {}, kUpright);
  ASSERT_EQ(list.texts.size(), 3U);
  EXPECT_EQ(list.texts[1].utf8, "N");
  EXPECT_LT(list.texts[1].size, 12);
  EXPECT_GT(list.texts[1].x, 21) << "lowered: to the right";
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(list.texts[i].angle, kUpright);
    if (i > 0) {
      EXPECT_LT(list.texts[i].y, list.texts[i - 1].y);
    }
  }
  EXPECT_NEAR(list.texts[0].x, 20, 1e-3);
  const float width = textWidth(TextRuns{{"normal force F"}, {"N", false, true}, {" (N)"}}, 12);
  EXPECT_NEAR(list.texts[0].y, 100 + width / 2, 1e-3);
}

}  // namespace
}  // namespace asperity
