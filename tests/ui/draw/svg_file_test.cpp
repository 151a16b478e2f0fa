#include "ui/draw/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QByteArray>
#include <QRawFont>
#include <QXmlStreamReader>
#include <map>

#include "tests/ui/chart/sample_sheets.h"
#include "tests/ui/contact/sample_frame.h"
#include "ui/chart/diagram_picture.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/shapes.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;

struct SvgContent {
  std::string error;
  std::map<std::string, int> elements;
  std::vector<std::string> texts;
  std::string metadata, title;
};

/// Reads it as any XML reader would.
SvgContent read(const std::string& svg) {
  SvgContent content;
  QXmlStreamReader reader(QByteArray::fromStdString(svg));
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) continue;
    const std::string name = reader.name().toString().toStdString();
    ++content.elements[name];
    if (name == "text") content.texts.push_back(reader.readElementText().toStdString());
    if (name == "metadata") content.metadata = reader.readElementText().toStdString();
    if (name == "title") content.title = reader.readElementText().toStdString();
  }
  if (reader.hasError()) content.error = reader.errorString().toStdString();
  return content;
}

DrawList listOf(std::vector<DrawText> texts) {
  DrawList list;
  list.width = 100;
  list.height = 80;
  list.background = {1, 1, 1, 1};
  list.texts = std::move(texts);
  return list;
}

TEST(SvgFile, IsWellFormedWithEveryText) {
  std::vector<DrawList> lists{composeContact(*sampleFrame({.points = 300}), {}), DrawList{}};
  for (const std::vector<NamedSheet>& sheets : {figureSheets(), awkwardSheets()})
    for (const NamedSheet& named : sheets) lists.push_back(composeDiagrams(named.sheet, {}));
  for (const DrawList& list : lists) {
    const SvgContent content = read(svgText(list));
    EXPECT_EQ(content.error, "");
    ASSERT_EQ(content.texts.size(), list.texts.size());
    for (std::size_t i = 0; i < list.texts.size(); ++i)
      EXPECT_EQ(content.texts[i], list.texts[i].utf8);
  }
}

TEST(SvgFile, SamePictureSameBytes) {
  const DrawList list = composeDiagrams(figureSheets()[0].sheet, {});
  EXPECT_EQ(svgText(list), svgText(list));
}

TEST(SvgFile, KeepsTitleAndMetadata) {
  const std::string metadata = "{\"scene\": \"a < b && c > 'd'\", \"µ\": \"\x01\xFF\"}";
  const SvgContent content = read(svgText(listOf({}), {"A <title>", metadata}));
  EXPECT_EQ(content.error, "");
  EXPECT_EQ(content.title, "A <title>");
  EXPECT_THAT(content.metadata, HasSubstr("\"a < b && c > 'd'\", \"µ\": \""));
  EXPECT_EQ(read(svgText(listOf({}))).elements.count("metadata"), 0U);
}

TEST(SvgFile, EscapesTexts) {
  DrawText text;
  text.utf8 = "x < 3 & \"y\" > 4";
  const SvgContent content = read(svgText(listOf({text})));
  EXPECT_EQ(content.error, "");
  ASSERT_EQ(content.texts.size(), 1U);
  EXPECT_EQ(content.texts[0], text.utf8);
}

TEST(SvgFile, NumbersAreShortAndDoNotDrift) {
  DrawList list = listOf({});
  list.layers.emplace_back();
  addLine(list.layers[0], {{0.5F, 10}, {1.004F, 10.25F}, {-3, 9.999F}}, 1.5F, {1, 0, 0, 1});
  const std::string svg = svgText(list);
  EXPECT_THAT(svg, HasSubstr("d=\"M0.5 10l0.5 0.25-4-0.25\"")) << svg;
  EXPECT_THAT(svg, HasSubstr("stroke=\"#ff0000\" stroke-width=\"1.5\""));
  EXPECT_THAT(svg, Not(HasSubstr("stroke-opacity")));
}

TEST(SvgFile, ClipsWhatTheLayerClips) {
  DrawList list = listOf({});
  for (int i = 0; i < 2; ++i) {
    list.layers.emplace_back();
    list.layers.back().clip = {10, 10, 50.5F, 40};
    addRectangle(list.layers.back(), {0, 0, 100, 100}, Rgba{0, 0, 1, 0.5F});
  }
  const std::string svg = svgText(list);
  EXPECT_EQ(read(svg).elements["clipPath"], 1);  // the same one for both
  EXPECT_THAT(svg, HasSubstr("<rect x=\"10\" y=\"10\" width=\"50.5\" height=\"40\"/>"));
  EXPECT_THAT(svg, HasSubstr("fill=\"#0000ff\" fill-opacity=\"0.5\""));
}

TEST(SvgFile, TextsHaveAnchorAngleAndWeight) {
  DrawText text;
  text.utf8 = "up";
  text.x = 12;
  text.y = 34;
  text.size = 13.4F;
  text.angle = 1.57079633F;
  text.anchor = TextAnchor::Centre;
  text.bold = true;
  const std::string svg = svgText(listOf({text}));
  EXPECT_THAT(svg, HasSubstr("transform=\"translate(12 34) rotate(-90)\" font-size=\"13\" "
                             "font-weight=\"bold\" text-anchor=\"middle\""));
}

/// The embedded font has what the texts need, and is a small part of the whole.
TEST(SvgFile, EmbedsTheGlyphsInUse) {
  const DrawList list = composeDiagrams(figureSheets()[0].sheet, {});
  for (const bool bold : {false, true}) {
    const QByteArray part = fontSubset(bold, charactersIn(list, bold));
    EXPECT_LT(part.size(), fontFile(bold).size() / 10);
    EXPECT_THAT(svgText(list), HasSubstr(part.toBase64().toStdString()));
    const QRawFont font(part, 20), whole(fontFile(bold), 20);
    ASSERT_TRUE(font.isValid());
    for (const char32_t c : charactersIn(list, bold)) {
      EXPECT_TRUE(font.supportsCharacter(c)) << static_cast<unsigned>(c);
      const auto advance = [&](const QRawFont& of) {
        return of.advancesForGlyphIndexes(of.glyphIndexesForString(QString::fromUcs4(&c, 1)))[0];
      };
      EXPECT_NEAR(advance(font).x(), advance(whole).x(), 0.01) << static_cast<unsigned>(c);
    }
  }
}

}  // namespace
}  // namespace asperity
