// Options of figures: one grammar for the command line and for style files.
#include "core/chart/figure_style.h"

#include <gmock/gmock.h>

#include "core/base/input_error.h"
#include "core/chart/curve_diagram.h"
#include "tests/core/error_from.h"

namespace asperity {
namespace {

using testing::HasSubstr;

FigureStyle with(const std::string& word, const std::string& value) {
  FigureStyle style;
  for (const FigureOption& option : figureOptions())
    if (option.word == word)
      if (const Message refusal = option.set(style, value); !refusal.empty())
        throw InputError("", word, refusal);
  return style;
}

std::string refusal(const std::string& word, const std::string& value) {
  return errorFrom([&] { with(word, value); });
}

std::string refusedFile(const std::string& json) {
  return errorFrom([&] { styleFromJson(json, "mine.json"); });
}

DiagramSheet twoCurves() {
  Diagram diagram;
  diagram.x.title = "velocity";
  diagram.spans.push_back({1, 2, "I", "I"});
  DiagramSeries law{.name = "Eq. (11)", .isTheory = true};
  DiagramSeries first{.name = "one"};
  DiagramSeries second{.name = "two"};
  diagram.series = {law, first, second};
  DiagramSheet sheet{.title = "A title",
                     .subtitle = "parameters",
                     .note = sentences({"Regions as read from the curve: so.", "Another remark."}),
                     .diagrams = {diagram}};
  return sheet;
}

TEST(PictureSize, IsInPixelsOrOnPaper) {
  const auto inches = [](const char* text) {
    const auto size = parsePictureSize(text);
    return size && size->isOnPaper() ? size->width / size->perInch : -1;
  };
  EXPECT_NEAR(inches("86mmx60mm"), 86 / 25.4, 1e-12);
  EXPECT_NEAR(inches("86x60mm"), 86 / 25.4, 1e-12);
  EXPECT_NEAR(inches("8.6cmx6cm"), 86 / 25.4, 1e-12);
  EXPECT_NEAR(inches("3.5inx2.5in"), 3.5, 1e-12);
  EXPECT_NEAR(inches("252ptx180pt"), 3.5, 1e-12);
  EXPECT_NEAR(parsePictureSize("10cmx50mm")->height, 5, 1e-12);  // in centimetres, as the width
  EXPECT_FALSE(parsePictureSize("1200x800")->isOnPaper());
  EXPECT_FALSE(parsePictureSize("1200pxx800px")->isOnPaper());
  for (const char* text : {"", "x", "86", "86mm", "86mmx", "x60mm", "86mmx60", "-1x5", "0x5", "axb",
                           "86mmx60px", "86 furlongx3furlong", "infx5", "nanx5", "1e999x5"})
    EXPECT_FALSE(parsePictureSize(text)) << text;
}

TEST(FigureOptions, RefuseWhatTheyDoNotKnow) {
  EXPECT_THAT(refusal("font-size", "huge"), HasSubstr("'huge' is not a number"));
  EXPECT_THAT(refusal("font-size", "100"), HasSubstr("outside 4 to 72 pt"));
  EXPECT_EQ(refusal("font-size", "7pt"), "no error");
  EXPECT_THAT(refusal("legend", "left"), HasSubstr("left is not one of auto, none, inside, below"));
  EXPECT_THAT(refusal("curve-style", "2=pink"), HasSubstr("'pink' is neither a colour"));
  EXPECT_THAT(refusal("curve-style", "0=black"), HasSubstr("NUMBER=WORDS"));
  EXPECT_THAT(refusal("labels", "x"), HasSubstr("not KEY=TEXT"));
}

TEST(StyleFile, HasTheSameWords) {
  const FigureStyle style = styleFromJson(
      R"style({"schema": "asperity-style/1", "font_size": 8.5, "regions": false, "title": "none",
               "labels": ["x=speed", "y=friction"], "panel_letters": "(a)"})style",
      "mine.json");
  EXPECT_EQ(style.fontSize, 8.5);
  EXPECT_FALSE(style.hasRegions);
  EXPECT_FALSE(style.hasTitle);
  EXPECT_EQ(style.labels.size(), 2U);
  EXPECT_EQ(style.letters, PanelLetters::Bracketed);
  EXPECT_THAT(
      refusedFile(R"({"fontsize": 8})"),
      HasSubstr("mine.json: fontsize: is not an option of a style; did you mean font_size?"));
  EXPECT_THAT(refusedFile(R"({"font_size": "x"})"), HasSubstr("mine.json: font_size: 'x' is not"));
  EXPECT_THAT(refusedFile(R"({"font_size": [1]})"), HasSubstr("mine.json: font_size"));
  EXPECT_THAT(refusedFile(R"([])"), HasSubstr("mine.json"));
  EXPECT_THAT(refusedFile("nonsense"), HasSubstr("mine.json"));
  EXPECT_THAT(refusedFile(R"({"schema": "asperity-scene/1"})"), HasSubstr("schema"));
}

TEST(StyleFile, ShippedOnesAreWhole) {
  EXPECT_THAT(namesOf(shippedStyles()),
              testing::ElementsAre("screen", "journal", "slides", "poster", "greyscale"));
  for (const std::string_view name : namesOf(shippedStyles()))
    EXPECT_NO_THROW(readStyle(std::string(name)));
  EXPECT_TRUE(readStyle("greyscale").isGrey);
  EXPECT_THROW(readStyle("no such style"), InputError);
}

/// On paper a picture of several panels grows in height; a slide has the shape of the screen.
TEST(StyleFile, ASlideHasTheShapeOfAScreen) {
  const auto size = parsePictureSize(readStyle("slides").size);
  ASSERT_TRUE(size);
  EXPECT_FALSE(size->isOnPaper());
  EXPECT_DOUBLE_EQ(9 * size->width, 16 * size->height);
}

TEST(StyledSheet, LeavesOutAndRenames) {
  FigureStyle style;
  style.hasTitle = style.hasRegions = style.hasLaw = false;
  style.labels = {{"x", "speed"}, {"2", "second"}, {"one", "first"}};
  const DiagramSheet sheet = styled(twoCurves(), style);
  EXPECT_TRUE(sheet.title.empty() && sheet.subtitle.empty());
  EXPECT_EQ(sheet.note.english(), "Another remark.");
  const Diagram& diagram = sheet.diagrams.front();
  EXPECT_TRUE(diagram.spans.empty());
  EXPECT_EQ(diagram.x.title.english(), "speed");
  ASSERT_EQ(diagram.series.size(), 2U);
  EXPECT_EQ(diagram.series[0].name.english(), "first");
  EXPECT_EQ(diagram.series[1].name.english(), "second");
}

TEST(StyledSheet, CurvesAreNumberedAsInTheLegend) {
  FigureStyle style = with("curve-style", "2=#d55e00,diamond,dotted");
  const DiagramSheet sheet = styled(twoCurves(), style);
  const DiagramSeries& second = sheet.diagrams.front().series[2];
  EXPECT_EQ(second.rgb, 0xD55E00U);
  EXPECT_EQ(second.mark, SeriesMark::Diamond);
  EXPECT_EQ(second.stroke, SeriesStroke::Dotted);
  style.curves.front().first = 4;  // one, two, Eq. (11)
  EXPECT_THROW(styled(twoCurves(), style), InputError);
  FigureStyle label;
  label.labels = {{"three", "?"}};
  EXPECT_THROW(styled(twoCurves(), label), InputError);
}

TEST(StyledSheet, PartsWithoutANameTakeTheColourOfTheirCurve) {
  DiagramSheet sheet = twoCurves();
  std::vector<DiagramSeries>& series = sheet.diagrams.front().series;
  series[2].id = kDifferenceCurve;
  DiagramSeries beyond{.mark = SeriesMark::Triangle, .id = kDifferenceCurve};
  series.push_back(beyond);
  FigureStyle style = with("curve-style", "2=#d55e00,diamond");
  style.labels = {{"2", "renamed"}};
  const DiagramSeries& part = styled(sheet, style).diagrams.front().series.back();
  EXPECT_EQ(part.rgb, 0xD55E00U);
  EXPECT_EQ(part.mark, SeriesMark::Triangle);
  EXPECT_TRUE(part.name.empty());
}

TEST(StyledSheet, WithoutOptionsIsTheSame) {
  const DiagramSheet before = twoCurves(), after = styled(before, {});
  EXPECT_EQ(before.title, after.title);
  EXPECT_EQ(before.note, after.note);
  EXPECT_EQ(before.diagrams[0].series.size(), after.diagrams[0].series.size());
  EXPECT_EQ(before.diagrams[0].spans.size(), after.diagrams[0].spans.size());
}

}  // namespace
}  // namespace asperity
