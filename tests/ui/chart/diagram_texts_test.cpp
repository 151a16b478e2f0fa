// Texts of composed diagrams: all on the picture, none over another, over many sizes and sheets.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/chart/curve_diagram.h"
#include "core/run/line_diagrams.h"
#include "core/run/steady_frames.h"
#include "core/run/transient_diagram.h"
#include "tests/ui/chart/sample_sheets.h"
#include "tests/ui/contact/tidy_texts.h"
#include "ui/chart/diagram_axes.h"
#include "ui/chart/diagram_legend.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/shapes.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {
namespace {

struct Size {
  int width, height;
  float scale;
};
constexpr Size kSizes[] = {{320, 200, 1},   {320, 568, 1},    {640, 400, 1},   {640, 400, 2},
                           {640, 400, 3},   {800, 600, 1.5F}, {1200, 800, 1},  {1200, 800, 2},
                           {1200, 800, 3},  {1920, 1080, 1},  {2400, 1600, 2}, {3840, 2160, 1},
                           {3840, 2160, 2}, {3840, 2160, 3},  {3000, 500, 1},  {500, 1500, 1}};

void expectTidySheets(const std::vector<NamedSheet>& sheets) {
  for (const NamedSheet& named : sheets)
    for (const Size& size : kSizes) {
      const DrawList list =
          composeDiagrams(named.sheet, {size.width, size.height, size.scale, lightTheme()});
      EXPECT_EQ(list.width, size.width);
      EXPECT_EQ(list.height, size.height);
      expectTidy(list, named.name + " " + std::to_string(size.width) + "x" +
                           std::to_string(size.height) + " scale " + std::to_string(size.scale));
    }
}

bool says(const DrawList& list, const std::string& words) {
  return ("|" + allTexts(list)).find("|" + words + "|") != std::string::npos;
}

TEST(DiagramTexts, OfTheFiguresNeverCollideNorLeaveThePicture) {
  expectTidySheets(figureSheets());
}

TEST(DiagramTexts, OfAwkwardSheetsNeverCollideNorLeaveThePicture) {
  expectTidySheets(awkwardSheets());
}

/// Nothing that was asked for is missing at the usual sizes.
TEST(DiagramTexts, AreAllThereAtUsualSizes) {
  for (const Size& size : {Size{1200, 800, 1}, {2400, 1600, 2}, {1600, 1000, 1}}) {
    for (const NamedSheet& named : figureSheets()) {
      const DrawList list =
          composeDiagrams(named.sheet, {size.width, size.height, size.scale, darkTheme()});
      const DiagramSheet shown = translated(named.sheet);
      std::vector<std::string> wanted{shown.title.text};
      for (const Diagram& diagram : shown.diagrams) {
        if (!diagram.ramp)
          for (const DiagramSeries& series : diagram.series) wanted.push_back(series.name.text);
        else
          wanted.insert(wanted.end(),
                        {diagram.ramp->title.text, diagram.ramp->from.text, diagram.ramp->to.text});
        for (const DiagramSpan& span : diagram.spans) wanted.push_back(span.label.text);
        for (const DiagramLabel& label : diagram.labels) wanted.push_back(label.text.text);
      }
      std::erase(wanted, "");
      for (const std::string& words : wanted)
        EXPECT_TRUE(says(list, words)) << named.name << ": " << words;
    }
  }
}

/// A shade's name stands in it, in lines; where it has no room there is none, and never a part.
TEST(DiagramTexts, ShadesAreNamedWhereTheyHaveRoom) {
  DiagramSheet sheet = sheetOf({{1e-5, 1e-3}, {1e-2, 1}, {1e3, 1}});
  sheet.diagrams[0].x = {"v", "m/s", AxisScale::Logarithmic, 1e-5, 1e3};
  const auto shown = [&](double from) {
    sheet.diagrams[0].shades = {{from, 1e3, "few contacts carry the load"}};
    return composeDiagrams(sheet, {900, 600, 1, lightTheme()});
  };
  EXPECT_TRUE(says(shown(1e-4), "few contacts carry the load"));
  const DrawList narrow = shown(30);
  EXPECT_FALSE(says(narrow, "few contacts carry the load"));
  EXPECT_NE(allTexts(narrow).find("few"), std::string::npos) << "in lines";
  EXPECT_EQ(allTexts(shown(900)).find("few"), std::string::npos);
}

/// Names of regions are written out or by their number, never cut.
TEST(DiagramTexts, RegionsAreNamedWholeOrByNumber) {
  DiagramSheet sheet = sheetOf({{1e-5, 1e-3}, {1e-2, 1}, {1e3, 1}});
  Diagram& diagram = sheet.diagrams[0];
  diagram.x = {"v", "m/s", AxisScale::Logarithmic, 1e-5, 1e3};
  diagram.spans = {{1e-5, 1e-2, "I linear", "I"}, {1e-2, 4e-2, "II transition", "II"}};
  for (const int width : {320, 400, 500, 700, 1000, 2000}) {
    const std::string texts = allTexts(composeDiagrams(sheet, {width, 300, 1, lightTheme()}));
    EXPECT_EQ(texts.find("\u2026"), texts.npos) << texts;
  }
  EXPECT_TRUE(says(composeDiagrams(sheet, {700, 300, 1, lightTheme()}), "II"));
  EXPECT_TRUE(says(composeDiagrams(sheet, {3000, 500, 1, lightTheme()}), "II transition"));
}

/// Of a text: the pixels that it covers, without its tails.
Box coveredBy(const DrawText& text) {
  const float width = textWidth(text.utf8, text.size, text.bold);
  const float left = text.anchor == TextAnchor::Left     ? text.x
                     : text.anchor == TextAnchor::Centre ? text.x - width / 2
                                                         : text.x - width;
  return {left, text.y - 0.7F * text.size, width, 0.7F * text.size};
}

/// Whether a curve (a line inside a frame) passes through the box.
bool isCrossed(const DrawList& list, const Box& box) {
  constexpr int kSteps = 200;
  for (const DrawLayer& layer : list.layers)
    for (const DrawLine& line : layer.lines)
      for (std::size_t i = 1; layer.clip.width > 0 && i < line.vertices.size(); ++i)
        for (int k = 0; k <= kSteps; ++k) {
          const float part = static_cast<float>(k) / kSteps;
          const float x = std::lerp(line.vertices[i - 1].x, line.vertices[i].x, part);
          const float y = std::lerp(line.vertices[i - 1].y, line.vertices[i].y, part);
          if (x > box.x && x < box.right() && y > box.y && y < box.bottom()) return true;
        }
  return false;
}

/// A journal's column at 300 dpi, in the language with the longer words: nothing is shortened, and
/// neither the legend nor the label of the tint lies over a curve.
TEST(DiagramTexts, LegendAndLabelsHideNoCurve) {
  Scene scene;
  scene.title = "Figure 2";
  std::vector<CurvePoint> points;
  for (int i = 0; i < 41; ++i) {
    CurvePoint point;
    point.velocity = 1e-5 * std::pow(10, 0.2 * i);
    const double vbar = 2.83 * point.velocity;
    point.dimensionlessVelocity = vbar;
    point.mu = 2.8e-3 * vbar / std::hypot(vbar, 1.0) / (1 + 5e-4 * point.velocity);
    point.normalizedMu = point.mu / 2e-3;
    point.muStandardError = 0.02 * point.mu;
    point.muLaw = 3e-3 * vbar / std::hypot(vbar, 1.3);
    point.realizations = 200;
    points.push_back(point);
  }
  DiagramSheet sheet = curveSheet(scene, points);
  sheet.diagrams[0].marker = DiagramMarker{"this line, now", "v = 1 m/s", 1, 2.6e-3};
  ASSERT_EQ(sheet.diagrams[0].shades.size(), 1U);
  for (const char* code : {"en", "de"})
    for (const Size& size : {Size{1016, 760, 3.125F}, {1200, 800, 1}, {640, 480, 1}}) {
      useLanguage(code);
      const DrawList list =
          composeDiagrams(sheet, {size.width, size.height, size.scale, printTheme()});
      const DiagramSheet german = translated(sheet);
      std::vector<std::string> names{german.diagrams[0].marker->name.text,
                                     german.diagrams[0].marker->label.text,
                                     german.diagrams[0].shades[0].label.text};
      for (const DiagramSeries& series : german.diagrams[0].series)
        names.push_back(series.name.text);
      int found = 0;
      for (const DrawText& text : list.texts)
        for (const std::string& name : names)
          if (name.find(text.utf8) != name.npos && text.utf8.size() > 3) {
            ++found;
            EXPECT_FALSE(isCrossed(list, coveredBy(text))) << text.utf8 << size.width << code;
          }
      EXPECT_GE(found, 3) << allTexts(list);
      EXPECT_EQ(allTexts(list).find("\u2026"), std::string::npos) << allTexts(list);
      expectTidy(list, code);
    }
  useLanguage("en");
}

/// The label of the marker stands beside its line, even where curves surround the point.
TEST(DiagramTexts, TheLabelOfAMarkerIsBesideItsLine) {
  for (const Size& size : {Size{1200, 800, 1}, {600, 400, 1}, {2000, 1400, 3}}) {
    DiagramSheet sheet = sheetOf({});
    Diagram& diagram = sheet.diagrams[0];
    diagram.series[0].name = {};
    diagram.series[0].mark = SeriesMark::None;
    for (int i = 0; i <= 200; ++i)
      diagram.series[0].points.push_back({0.01 * i, 1 + 0.9 * std::sin(0.63 * i)});
    diagram.marker = DiagramMarker{{}, "v = 300 mm/s", 1, 1};
    const DiagramOptions options{size.width, size.height, size.scale, lightTheme()};
    const float line = static_cast<float>(diagramFrames(sheet, options)[0].mapX(1));
    bool isThere = false;
    for (const DrawText& text : composeDiagrams(sheet, options).texts) {
      if (text.utf8 != "v = 300 mm/s") continue;
      isThere = true;
      const Box box = coveredBy(text);
      EXPECT_TRUE(box.right() < line || box.x > line) << size.width;
    }
    EXPECT_TRUE(isThere) << size.width;
  }
}

/// A legend above one frame lowers the frame beside it, too.
TEST(DiagramTexts, FramesOfARowLineUp) {
  Diagram full{.x = {"position", "m", AxisScale::Linear}, .y = {"share", "%", AxisScale::Linear}};
  for (const char* name : {"in contact", "mean, force / length"}) {
    DiagramSeries series{.name = name};
    for (int i = 0; i < 200; ++i)  // leaves no room inside the frame
      series.points.push_back({static_cast<double>(i / 2), i % 2 == 0 ? 0.0 : 1.0});
    full.series.push_back(series);
  }
  Diagram plain = full;
  plain.series.resize(1);
  plain.series[0].name = {};
  DiagramSheet sheet;
  sheet.diagrams = {full, plain};
  const std::vector<ChartGeometry> frames = diagramFrames(sheet, {620, 300});
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].area.top(), frames[1].area.top());
  EXPECT_EQ(frames[0].area.bottom(), frames[1].area.bottom());
  sheet.diagrams = {plain, plain};
  EXPECT_GT(frames[1].area.top(), diagramFrames(sheet, {620, 300})[1].area.top());
}

/// What is nowhere on the axes is not in the legend.
TEST(DiagramTexts, CurvesOffTheAxesAreNotInTheLegend) {
  DiagramSheet sheet = sheetOf({{1, 1}, {2, 3}});
  Diagram& diagram = sheet.diagrams[0];
  diagram.x.scale = diagram.y.scale = AxisScale::Logarithmic;
  diagram.series.push_back({.name = "no friction", .points = {{1, 0}, {2, 0}}});
  diagram.marker = DiagramMarker{"this motion, now", "|v| = 0 m/s", 0, 1};
  const DrawList list = composeDiagrams(sheet, {900, 600, 1, lightTheme()});
  EXPECT_TRUE(says(list, "points"));
  EXPECT_FALSE(says(list, "no friction"));
  EXPECT_FALSE(says(list, "this motion, now"));
  EXPECT_FALSE(says(list, "|v| = 0 m/s"));
}

/// Letters of a given size leave little space on a small page: the legend then is under the axis,
/// whole, and the note ends with a sentence.
TEST(DiagramTexts, OfASmallPageHideNoCurveAndAreWhole) {
  DiagramSheet sheet = sheetOf({{1e-4, 3e-6}, {1e-1, 1e-3}, {1, 2e-3}, {1e3, 2e-4}});
  sheet.title = "Region IV: friction falls again";
  sheet.subtitle = "L = 20 mm; N = 2000; H = 0.7; h = 500 nm; G = 10 MPa; F\u2099 = 3.4 mN";
  sheet.note =
      "Regions as read from the curve: I ends 20 % below its line, III lies above 95 % of the "
      "maximum. Tinted: F\u2099/(4\u03B7v), the height that all contacts climb, is below a tenth "
      "of "
      "the rms height, and single summits carry the load.";
  Diagram& diagram = sheet.diagrams[0];
  diagram.series[0].name = "mean of 100 lines \u00B1 standard error";
  diagram.series.push_back({.name = "Eq. (11)", .isTheory = true});
  diagram.series.back().points = {{1e-4, 3e-6}, {1, 2e-3}, {1e3, 2e-3}};
  diagram.marker = DiagramMarker{"this line, now", "v = 300 m/s", 300, 4e-4};
  DiagramOptions options{1016, 709, 4.17F, printTheme()};
  options.format.fontSize = 31;
  options.format.minFontSize = 25;
  const DrawList list = composeDiagrams(sheet, options);
  for (const char* name :
       {"mean of 100 lines \u00B1 standard error", "Eq. (11)", "this line, now", "v = 300 m/s"}) {
    EXPECT_TRUE(says(list, name)) << name << " in " << allTexts(list);
    for (const DrawText& text : list.texts)
      EXPECT_FALSE(text.utf8 == name && isCrossed(list, coveredBy(text))) << text.utf8;
  }
  EXPECT_EQ(allTexts(list).find("\u2026"), std::string::npos) << allTexts(list);
  EXPECT_NE(allTexts(list).find("maximum."), std::string::npos) << allTexts(list);
  const ChartGeometry frame = diagramFrames(sheet, options)[0];
  EXPECT_GT(frame.area.width(), 0.7 * options.width);
  expectTidy(list, "small page");
}

DiagramSheet sheetOfCurves(const std::vector<std::string>& names) {
  DiagramSheet sheet = sheetOf({{1e-5, 1e-2}, {1e-3, 1e-6}});
  sheet.title = {};
  const DiagramSeries series = sheet.diagrams[0].series[0];
  sheet.diagrams[0].series.assign(names.size(), series);
  for (std::size_t i = 0; i < names.size(); ++i)
    sheet.diagrams[0].series[i].name = Message::name(names[i]);
  return sheet;
}

/// As in the window's low views, where names would not fit into the frame.
TEST(DiagramTexts, ALegendThatFitsBesideTheFrameIsWhole) {
  const DiagramSheet sheet =
      sheetOfCurves({"literal march (difference)", "nodal (difference)", "linear", "cubic",
                     "best for the time", "this scene: cubic \u00D72"});
  const DrawList list = composeDiagrams(sheet, {573, 178, 1, lightTheme(), 0.9F});
  for (const DiagramSeries& each : sheet.diagrams[0].series)
    EXPECT_TRUE(says(list, each.name.text)) << each.name;
  expectTidy(list, "low view");
}

/// In a small window a legend may have less room than it needs, but a reader sees that it has.
TEST(DiagramTexts, ALegendIsWholeOrSaysThatItIsNot) {
  const std::vector<std::string> names{"literal march (difference)", "nodal (difference)", "linear",
                                       "cubic", "best for the time"};
  for (int width = 400; width <= 900; width += 20) {
    const DrawList list =
        composeDiagrams(sheetOfCurves(names), {width, 178, 1, lightTheme(), 0.9F});
    const std::string texts = allTexts(list);
    const bool isWhole =
        std::ranges::all_of(names, [&](const std::string& name) { return says(list, name); });
    EXPECT_TRUE(isWhole || texts.find("…") != texts.npos || texts.find(" more|") != texts.npos)
        << width << ": " << texts;
  }
}

/// Letters get smaller before names are cut.
TEST(DiagramTexts, ALegendThatCannotBeWholeHasItsSmallestLetters) {
  const DiagramOptions options{573, 178, 1, lightTheme(), 0.9F};
  const auto sizeOf = [&](const DiagramSheet& sheet, const std::string& beginning) {
    for (const DrawText& text : composeDiagrams(sheet, options).texts)
      if (text.utf8.starts_with(beginning)) return text.size;
    return 0.0F;
  };
  const float usual = sizeOf(sheetOfCurves({"one", "two"}), "one");
  const std::string longName(200, 'n');
  const float smaller = sizeOf(sheetOfCurves({longName + "1", longName + "2"}), "nn");
  EXPECT_GT(smaller, 0);
  EXPECT_LT(smaller, usual);
}

/// A column of short names leaves its room to one of long names.
TEST(DiagramTexts, ColumnsOfALegendAreAsWideAsTheirNames) {
  const DiagramSheet sheet = sheetOfCurves({"a name that takes very much room in a legend",
                                            "another name that takes very much room", "a", "b"});
  const Diagram& diagram = sheet.diagrams[0];
  const std::vector<SeriesStyle> styles(diagram.series.size());
  constexpr float kSize = 12;
  const Legend one = legendFor(diagram, styles, kSize, 2000, 2000);
  const Legend two = legendFor(diagram, styles, kSize, 2000, 0.7F * one.height);
  ASSERT_EQ(one.columns, 1);
  ASSERT_EQ(two.columns, 2);
  EXPECT_TRUE(two.isWhole);
  EXPECT_LT(two.width, 1.7F * one.width);
}

/// The tabs of a window of 1280 x 720, in each language: nothing is shortened.
TEST(DiagramTexts, TheWindowsLowViewsSayAllTheirAxesAreOf) {
  Scene scene;
  scene.surface.elements = 400;
  const auto frame = SteadyFrames(std::make_shared<const Scene>(scene)).frame(0, 1, 25);
  for (const char* code : {"en", "de"}) {
    useLanguage(code);
    for (const DiagramSheet& sheet : {spectrumSheet(scene), statisticsSheet(frame)}) {
      const DrawList list = composeDiagrams(sheet, {899, 209, 1, lightTheme(), 0.85F});
      EXPECT_EQ(allTexts(list).find("…"), std::string::npos) << allTexts(list);
      for (const Diagram& diagram : translated(sheet).diagrams)
        for (const DiagramAxis* axis : {&diagram.x, &diagram.y})
          EXPECT_NE(allTexts(list).find(axis->title.text), std::string::npos) << axis->title;
      expectTidy(list, code);
    }
  }
  useLanguage("en");
}

TEST(DiagramTexts, AxesCarryTheirUnits) {
  EXPECT_TRUE(says(composeDiagrams(figureSheets()[0].sheet, {}), "sliding velocity (m/s)"));
  EXPECT_TRUE(says(composeDiagrams(figureSheets()[1].sheet, {}), "coefficient of friction μ"));
  EXPECT_TRUE(says(composeDiagrams(sheetOf({{0.001, 1}, {0.004, 2}}), {}), "x (mm)"));
  const DrawList small = composeDiagrams(sheetOf({{1, 1e-6}, {2, 3e-6}}), {});
  EXPECT_TRUE(says(small, "y (10⁻⁶)")) << allTexts(small);
}

TEST(DiagramTexts, SeriesOnARampAreNotInTheLegend) {
  const std::string words = allTexts(composeDiagrams(figureSheets()[2].sheet, {}));
  EXPECT_EQ(words.find("force 1"), std::string::npos);
}

TEST(DiagramTexts, EntriesWithoutRoomAreCounted) {
  const std::vector<NamedSheet> sheets = awkwardSheets();
  const auto crowd = std::find_if(sheets.begin(), sheets.end(),
                                  [](const auto& named) { return named.name == "thirty curves"; });
  ASSERT_NE(crowd, sheets.end());
  const std::string words = allTexts(composeDiagrams(crowd->sheet, {800, 500, 1, lightTheme()}));
  EXPECT_NE(words.find(" more|"), std::string::npos) << words;
}

/// Low as a tab under the contact, with texts that can be read.
TEST(DiagramTexts, StayReadableInLowTabs) {
  Scene scene;
  scene.surface.elements = 400;
  const Frame frame = SteadyFrames(std::make_shared<const Scene>(scene)).frame(0, 1, 25);
  for (const DiagramSheet& sheet : {spectrumSheet(scene), statisticsSheet(frame)})
    for (const Size& size : {Size{850, 210, 1}, {640, 200, 1}, {1700, 420, 2}, {2100, 600, 1}}) {
      DiagramOptions options{size.width, size.height, size.scale, darkTheme()};
      options.minTextSize = 0.85F;
      const DrawList list = composeDiagrams(sheet, options);
      expectTidy(list, sheet.note.english() + std::to_string(size.width));
      for (const DrawText& text : list.texts)  // exponents are smaller
        EXPECT_GE(text.size, 7 * size.scale) << text.utf8;
      EXPECT_GE(list.texts.front().size, 9 * size.scale);
    }
}

int timesSaid(const DrawList& list) {
  return static_cast<int>(std::ranges::count_if(
      list.texts, [](const DrawText& text) { return text.utf8.find("time t") == 0; }));
}

/// Of strips over time: the symbol and the unit are left of a name, and more than one tick.
TEST(DiagramTexts, OfLowStripsSayWhatAndHowMuch) {
  DiagramSheet sheet;
  sheet.columns = 1;
  for (const char* name : {"velocity v", "friction \u03BC", "indentation d"}) {
    Diagram strip;
    strip.x = {"time t", "s", AxisScale::Linear};
    strip.y = {name, "m/s", AxisScale::Linear};
    DiagramSeries series;
    series.points = {{0, -0.31}, {0.01, 0.29}, {0.02, -0.3}};
    strip.series = {series};
    sheet.diagrams.push_back(strip);
  }
  DiagramOptions options;
  options.width = 1280;
  options.height = 331;
  options.minTextSize = 0.8F;
  const DrawList list = composeDiagrams(sheet, options);
  std::string texts;
  int marks = 0;
  for (const DrawText& text : list.texts) {
    texts += text.utf8 + "|";
    marks += text.utf8 == "200" || text.utf8 == "\u2212200";
  }
  EXPECT_EQ(timesSaid(list), 3);
  sheet.sharesAxis = true;
  EXPECT_EQ(timesSaid(composeDiagrams(sheet, options)), 1);
  for (const char* title : {"|v (mm/s)|", "|\u03BC (mm/s)|", "|d (mm/s)|"})
    EXPECT_NE(texts.find(title), texts.npos) << texts;
  EXPECT_EQ(marks, 6) << texts;
}

/// A line of the note ends where the width does, not already at its first comma; a number stays
/// with its unit.
TEST(DiagramTexts, OfTheNoteFillTheirLines) {
  DiagramSheet sheet = sheetOf({{0, 1}, {1, 3}, {2, 2}});
  sheet.note =
      "Regions as read from the curve: I ends 20 % below its line, III lies above 95 % of the "
      "maximum. It is the sum of the heights climbed by all contacts of one period; the border "
      "moves with the period.";
  for (const int width : {700, 760, 820, 900}) {
    const DrawList list = composeDiagrams(sheet, {width, 500, 1, lightTheme()});
    std::vector<const DrawText*> lines;
    for (const DrawText& text : list.texts)
      if (text.y > 440) lines.push_back(&text);
    const auto first = std::ranges::find_if(
        lines, [](const DrawText* text) { return text->utf8.starts_with("Regions"); });
    ASSERT_NE(first, lines.end()) << width;
    EXPECT_GT(textWidth((*first)->utf8, (*first)->size), 0.8 * (width - 36)) << (*first)->utf8;
    for (const DrawText* text : lines) EXPECT_FALSE(text->utf8.starts_with("%")) << text->utf8;
  }
}

/// A strip below a contact is too low for an upright name: it stands above the frame in words, not
/// as a symbol that nothing explains.
TEST(DiagramTexts, OfStripsNameThemInWords) {
  Scene scene;
  scene.sliding.kind = SlidingKind::Oscillation;
  scene.sliding.duration = 0.006;
  std::vector<TransientSample> samples;
  for (int i = 0; i <= 60; ++i) {
    TransientSample sample;
    sample.time = i * 1e-4;
    sample.velocity = 0.5 * std::sin(0.3 * i);
    sample.mu = 1e-3 * std::abs(std::sin(0.3 * i));
    sample.indentation = 3e-7;
    sample.contactLength = 6e-5;
    samples.push_back(sample);
  }
  const DiagramSheet sheet = transientSheet(scene, samples, 4e-6, 0.02);
  DiagramOptions options{1280, 317, 1, lightTheme(), 0.8F};
  options.above = FrameAbove{60, 1262, 0};
  const DrawList list = composeDiagrams(sheet, options);
  expectTidy(list, "strips");
  const std::string texts = "|" + allTexts(list);
  for (const char* name :
       {"|velocity v (", "|friction \u03BC", "|indentation d (", "|length per contact \u2113 ("})
    EXPECT_NE(texts.find(name), texts.npos) << name << " in " << texts;
  EXPECT_GE(lowestFrame(sheet, options), 3);
}

/// Before the first step a strip has no values; 0, 0.5 and 1 m of indentation would be nonsense.
TEST(DiagramTexts, OfStripsWithoutValuesHaveNoNumbers) {
  Scene scene;
  scene.sliding.kind = SlidingKind::Oscillation;
  scene.sliding.duration = 0.006;
  DiagramOptions options{1280, 317, 1, lightTheme(), 0.8F};
  options.above = FrameAbove{60, 1262, 0};
  const DrawList list = composeDiagrams(transientSheet(scene, {}, 4e-6, 0.02), options);
  EXPECT_TRUE(says(list, "indentation d (m)")) << allTexts(list);
  EXPECT_TRUE(says(list, "6")) << "the time";
  EXPECT_FALSE(says(list, "0.5")) << allTexts(list);
  EXPECT_FALSE(says(list, "1.0")) << allTexts(list);
}

/// On a screen, and below a contact, whose axes have their ticks outside, those of a chart are
/// outside as well; in print they are inside, unless the user wishes them elsewhere.
TEST(DiagramTexts, TicksAreInsideInPrintOnly) {
  const DiagramSheet sheet = sheetOf({{0, 1}, {1, 3}, {2, 2}});
  const auto inside = [&](TickSide side, bool isBelow, const Theme& theme = printTheme()) {
    DiagramOptions options{900, 400, 1, theme};
    options.format.ticks = side;
    if (isBelow) options.above = FrameAbove{60, 880, 1};
    const Box frame = [&] {
      const QRectF area = diagramFrames(sheet, options).front().area;
      return Box{static_cast<float>(area.x()), static_cast<float>(area.y()),
                 static_cast<float>(area.width()), static_cast<float>(area.height())};
    }();
    // Short lines of the axis colour that hang from the upper edge into the frame.
    int marks = 0;
    for (const DrawLayer& layer : composeDiagrams(sheet, options).layers)
      for (const DrawLine& line : layer.lines)
        if (line.vertices.size() == 2 && line.vertices[0].x == line.vertices[1].x &&
            line.vertices[0].y == frame.y && line.vertices[1].y > frame.y &&
            line.vertices[1].y < frame.y + 20)
          ++marks;
    return marks;
  };
  EXPECT_GT(inside(TickSide::Automatic, false), 3);
  EXPECT_EQ(inside(TickSide::Automatic, true), 0);
  EXPECT_EQ(inside(TickSide::Automatic, false, lightTheme()), 0);
  EXPECT_EQ(inside(TickSide::Automatic, false, darkTheme()), 0);
  EXPECT_GT(inside(TickSide::Inside, true), 3);
  EXPECT_EQ(inside(TickSide::Outside, false), 0);
}

/// Without the power of ten a number on the axis is wrong by it.
TEST(DiagramTexts, OfStripsKeepUnitsAndPowersOfTenAtAnySize) {
  Scene scene;
  scene.sliding.kind = SlidingKind::Step;
  scene.sliding.duration = 0.008;
  std::vector<TransientSample> samples;
  for (int i = 0; i <= 40; ++i) {
    TransientSample sample;
    sample.time = i * 2e-4;
    sample.velocity = i < 20 ? 0.3 : 0.6;
    sample.mu = 1e-3 * (1.2 + 0.3 * std::exp(-0.2 * std::abs(i - 20)));
    sample.indentation = 2.9e-7 - 1e-9 * i;
    samples.push_back(sample);
  }
  for (const char* code : {"en", "de"}) {
    useLanguage(code);
    int shown = 0;
    for (const float scale : {1.0F, 3.125F})
      for (const int width : {300, 320, 420, 500, 640, 1016, 1280})
        for (const int height : {150, 161, 184, 240, 331, 460, 700})
          for (const float text : {0.5F, 0.6F, 0.8F}) {
            const DiagramOptions options{static_cast<int>(static_cast<float>(width) * scale),
                                         static_cast<int>(static_cast<float>(height) * scale),
                                         scale, lightTheme(), text};
            const DiagramSheet sheet =
                withoutCrowding(transientSheet(scene, samples, 4e-6, 0.02), options);
            if (lowestFrame(sheet, options) < 2) continue;
            ++shown;
            const DrawList list = composeDiagrams(sheet, options);
            const std::string where = fmt::format("{}x{} scale {} text {} {}: {}", width, height,
                                                  scale, text, code, allTexts(list));
            for (const char* unit : {"(mm/s)|", "(10\u207B\u00B3)|", "(nm)|", "(ms)|"})
              EXPECT_NE(allTexts(list).find(unit), std::string::npos) << unit << " " << where;
            if (text > 0.5F) continue;  // with smaller texts there is room for names as well
            for (const char* name : {"v (mm/s)", "\u03BC (10", "d (nm)", "t (ms)"})
              EXPECT_NE(allTexts(list).find(name), std::string::npos) << name << " " << where;
            EXPECT_EQ(allTexts(list).find("\u2026"), std::string::npos) << where;
            expectTidy(list, where);
          }
    EXPECT_GT(shown, 150) << code;
  }
  useLanguage("en");
}

/// A low diagram has the symbol in place of a name that is too long.
TEST(DiagramTexts, TheSymbolOfAnErrorIsNotThatOfTheQuantity) {
  EXPECT_EQ(trailingSymbol("coefficient of friction \u03BC"), "\u03BC");
  EXPECT_EQ(trailingSymbol("relative error of \u03BC"), "");
  EXPECT_EQ(trailingSymbol("relativer Fehler von \u03BC"), "");
  EXPECT_EQ(trailingSymbol("modulus G\u2032, G\u2033"), "");
  EXPECT_EQ(trailingSymbol("exponent d ln \u03BC / d ln x"), "");
  EXPECT_EQ(trailingSymbol("normal force F\u2099"), "F\u2099");
  EXPECT_EQ(trailingSymbol("a title of the user, which says what it is"), "");
}

}  // namespace
}  // namespace asperity
