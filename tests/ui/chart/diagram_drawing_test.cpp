// What is drawn of a diagram, and where: against the labels of its own axes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/number_text.h"
#include "tests/ui/chart/sample_sheets.h"
#include "ui/chart/diagram_axes.h"
#include "ui/chart/diagram_picture.h"
#include "ui/chart/diagram_style.h"
#include "ui/draw/fonts.h"
#include "ui/draw/ticks.h"

namespace asperity {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

bool same(const Rgba& a, const Rgba& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
}

/// Dots (lines of one vertex) of a colour, from left to right.
std::vector<DrawVertex> dotsOf(const DrawList& list, const Rgba& colour) {
  std::vector<DrawVertex> dots;
  for (const DrawLayer& layer : list.layers)
    for (const DrawLine& line : layer.lines)
      if (line.vertices.size() == 1 && same(line.vertices[0].colour, colour))
        dots.push_back(line.vertices[0]);
  std::sort(dots.begin(), dots.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return dots;
}

/// Lines of at least two vertices and a colour.
std::vector<DrawLine> linesOf(const DrawList& list, const Rgba& colour) {
  std::vector<DrawLine> lines;
  for (const DrawLayer& layer : list.layers)
    for (const DrawLine& line : layer.lines)
      if (line.vertices.size() > 1 && same(line.vertices[0].colour, colour)) lines.push_back(line);
  return lines;
}

const DrawText* textOf(const DrawList& list, const std::string& words) {
  const auto text = std::find_if(list.texts.begin(), list.texts.end(),
                                 [&](const DrawText& t) { return t.utf8 == words; });
  return text == list.texts.end() ? nullptr : &*text;
}

/// Of the label of a tick: the column where it is centred.
float columnOf(const DrawList& list, const std::string& words) {
  const DrawText* text = textOf(list, words);
  EXPECT_NE(text, nullptr) << words;
  return text ? text->x : 0;
}

/// A sheet without a legend, so that its dots are the points.
DiagramSheet unnamed(DiagramSheet sheet) {
  for (Diagram& diagram : sheet.diagrams)
    for (DiagramSeries& series : diagram.series) series.name = {};
  return sheet;
}

TEST(DiagramDrawing, PointsLieWhereALogarithmicAxisSays) {
  std::vector<DiagramPoint> points;
  for (int exponent = -3; exponent <= 3; ++exponent) {
    const double v = std::pow(10, exponent);
    points.push_back({v, v});
  }
  DiagramSheet sheet = unnamed(sheetOf(points));
  sheet.diagrams[0].x = {"v", "m/s", AxisScale::Logarithmic, 1e-4, 1e4};
  sheet.diagrams[0].y = {"mu", "", AxisScale::Logarithmic, 1e-4, 1e4};
  const DrawList list = composeDiagrams(sheet, {});
  const std::vector<DrawVertex> dots = dotsOf(list, seriesColour(0, lightTheme()));
  ASSERT_EQ(dots.size(), points.size());
  const float left = columnOf(list, powerOfTen(-3)), right = columnOf(list, powerOfTen(3));
  for (std::size_t i = 0; i < dots.size(); ++i) {
    const std::string label = powerOfTen(static_cast<int>(i) - 3);
    EXPECT_NEAR(dots[i].x, columnOf(list, label), 0.01) << label;
    EXPECT_NEAR(dots[i].x, left + (right - left) * static_cast<float>(i) / 6, 0.01) << label;
  }
  for (std::size_t i = 0; i + 1 < dots.size(); ++i)  // a power law is a straight line
    EXPECT_NEAR(dots[i].y - dots[i + 1].y, (dots.front().y - dots.back().y) / 6, 0.01);
}

TEST(DiagramDrawing, PointsLieWhereALinearAxisSays) {
  DiagramSheet sheet = unnamed(sheetOf({{0, 0.25}, {2, 0.75}, {4, 0.5}}));
  sheet.diagrams[0].x.from = -1;
  sheet.diagrams[0].x.to = 5;
  sheet.diagrams[0].y.from = 0;
  sheet.diagrams[0].y.to = 1;
  const DrawList list = composeDiagrams(sheet, {});
  const std::vector<DrawVertex> dots = dotsOf(list, seriesColour(0, lightTheme()));
  ASSERT_EQ(dots.size(), 3U);
  EXPECT_NEAR(dots[1].x, columnOf(list, "2"), 0.01);
  EXPECT_NEAR(dots[2].x - dots[1].x, dots[1].x - dots[0].x, 0.01);
  const DrawText *bottom = textOf(list, "0.0"), *top = textOf(list, "1.0");
  ASSERT_TRUE(bottom && top);
  EXPECT_NEAR(dots[0].y - dots[1].y, (bottom->y - top->y) / 2, 0.01);
  EXPECT_NEAR(dots[0].y - dots[2].y, (bottom->y - top->y) / 4, 0.01);
}

TEST(DiagramDrawing, WhatHasNoPlaceBreaksTheLine) {
  DiagramSheet sheet =
      unnamed(sheetOf({{1, 1}, {2, 2}, {3, 0}, {4, 2}, {5, kMissing}, {6, 3}, {7, 1}}));
  sheet.diagrams[0].series[0].mark = SeriesMark::None;
  const Rgba colour = seriesColour(0, lightTheme());
  EXPECT_EQ(linesOf(composeDiagrams(sheet, {}), colour).size(), 2U);  // broken at NaN alone
  sheet.diagrams[0].y.scale = AxisScale::Logarithmic;
  const std::vector<DrawLine> lines = linesOf(composeDiagrams(sheet, {}), colour);
  ASSERT_EQ(lines.size(), 3U);  // zero is below the axis: the line leaves the frame and comes back
  const float bottom = lines[0].vertices.back().y;
  EXPECT_EQ(lines[0].vertices.size(), 3U);
  EXPECT_NEAR(lines[1].vertices.front().y, bottom, 0.01);
  EXPECT_GT(bottom, lines[2].vertices.back().y) << "below the least value";
}

/// Whatever leaves the range ends at the frame.
TEST(DiagramDrawing, CurvesEndAtTheFrame) {
  DiagramSheet sheet = unnamed(sheetOf({{-100, -50}, {1, 0.5}, {100, 2000}}));
  Diagram& diagram = sheet.diagrams[0];
  diagram.x.from = diagram.y.from = 0;
  diagram.x.to = 2;
  diagram.y.to = 1;
  const DrawList list = composeDiagrams(sheet, {});
  const std::vector<DrawLine> frames = linesOf(list, seriesColour(0, lightTheme()));
  ASSERT_EQ(frames.size(), 1U);
  const float left = columnOf(list, "0.0"), right = columnOf(list, "2.0");
  for (const DrawVertex& v : frames[0].vertices) {
    EXPECT_GE(v.x, left - 0.01);
    EXPECT_LE(v.x, right + 0.01);
    EXPECT_GE(v.y, 0);
    EXPECT_LE(v.y, static_cast<float>(list.height));
  }
  EXPECT_EQ(dotsOf(list, seriesColour(0, lightTheme())).size(), 1U);  // marks outside are left out
}

TEST(DiagramDrawing, BandsAndBarsReachFromLowToHigh) {
  DiagramSheet sheet = unnamed(sheetOf({{1, 5, 4, 7}, {3, 5, 4, 7}}));
  DiagramSeries& series = sheet.diagrams[0].series[0];
  sheet.diagrams[0].y.from = 0;
  sheet.diagrams[0].y.to = 10;
  const auto rows = [](const DrawList& list) {  // of the labels "4" and the point itself
    return std::pair{textOf(list, "4"), textOf(list, "8")};
  };
  const Rgba colour = seriesColour(0, lightTheme());
  const DrawList bars = composeDiagrams(sheet, {});
  const auto [four, eight] = rows(bars);
  ASSERT_TRUE(four && eight);
  const float unit = (four->y - eight->y) / 4, point = dotsOf(bars, colour)[0].y;
  int upright = 0;
  for (const DrawLine& line : linesOf(bars, colour)) {
    if (line.vertices.size() != 2 || line.vertices[0].x != line.vertices[1].x) continue;
    ++upright;
    EXPECT_NEAR(line.vertices[0].y, point + unit, 0.02);
    EXPECT_NEAR(line.vertices[1].y, point - 2 * unit, 0.02);
  }
  EXPECT_EQ(upright, 2);

  series.isBand = true;
  const DrawList bands = composeDiagrams(sheet, {});
  float low = 0, high = 1e9F;
  for (const DrawLayer& layer : bands.layers)
    for (const DrawVertex& v : layer.triangles)
      if (v.colour.r == colour.r && v.colour.b == colour.b && v.colour.a < 1) {
        low = std::max(low, v.y);
        high = std::min(high, v.y);
      }
  EXPECT_NEAR(low, point + unit, 0.02);
  EXPECT_NEAR(high, point - 2 * unit, 0.02);
}

TEST(DiagramDrawing, TheoryHasTheColourOfTextAndLiesUnderTheData) {
  DiagramSheet sheet = unnamed(sheetOf({{0, 0}, {1, 1}}));
  DiagramSeries theory = sheet.diagrams[0].series[0];
  theory.isTheory = true;
  theory.mark = SeriesMark::None;
  sheet.diagrams[0].series.push_back(theory);
  const DrawList list = composeDiagrams(sheet, {});
  const auto layerWith = [&](const Rgba& colour) -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < list.layers.size(); ++i)
      for (const DrawLine& line : list.layers[i].lines)
        if (same(line.vertices[0].colour, colour) && list.layers[i].clip.width > 0) return i;
    return std::nullopt;
  };
  const auto under = layerWith(lightTheme().text), over = layerWith(seriesColour(0, lightTheme()));
  ASSERT_TRUE(under && over);
  EXPECT_LT(*under, *over);
}

/// Dash and gap along the curve: their sum is the same everywhere.
TEST(DiagramDrawing, DashesRepeatAlongTheCurve) {
  DiagramSheet sheet = unnamed(sheetOf({{0, 1}, {10, 1}}));
  sheet.diagrams[0].series[0].mark = SeriesMark::None;
  sheet.diagrams[0].series[0].stroke = SeriesStroke::Dashed;
  const std::vector<DrawLine> dashes =
      linesOf(composeDiagrams(sheet, {}), seriesColour(0, lightTheme()));
  ASSERT_GT(dashes.size(), 10U);
  const auto from = [&](std::size_t i) { return dashes[i].vertices[0].x; };
  const float period = from(1) - from(0);
  for (std::size_t i = 0; i + 2 < dashes.size(); ++i) {
    EXPECT_NEAR(from(i + 1) - from(i), period, 0.02);
    EXPECT_NEAR(dashes[i].vertices.back().x - from(i), dashes[0].vertices.back().x - from(0), 0.02);
  }
}

/// A line between two rows of pixels would be pale and twice as wide.
TEST(DiagramDrawing, LinesOfAxesCoverWholePixels) {
  const Theme& theme = lightTheme();
  for (const float scale : {1.0F, 1.5F, 2.0F, 2.75F}) {
    const DrawList list =
        composeDiagrams(sheetOf({{0, 1}, {1, 3.3}, {2.7, 2}}), {901, 613, scale, theme});
    int count = 0;
    for (const Rgba& colour : {theme.axis, theme.grid})
      for (const DrawLine& line : linesOf(list, colour)) {
        EXPECT_EQ(line.width, std::round(line.width));
        for (std::size_t i = 0; i + 1 < line.vertices.size(); ++i) {
          const DrawVertex &from = line.vertices[i], &to = line.vertices[i + 1];
          const float edge = (from.x == to.x ? from.x : from.y) - line.width / 2;
          EXPECT_NEAR(edge, std::round(edge), 1e-3) << scale << " " << from.x << " " << from.y;
          ++count;
        }
      }
    EXPECT_GT(count, 20) << scale;
  }
}

/// The name of a marker stands beside its ring, not on it.
TEST(DiagramDrawing, TheNameOfAMarkerIsClearOfItsRing) {
  for (const char* text : {"F = 3 N", "F = 3.4 mN", "v = 100 mm/s", "T = 298 K", "v = 1 m/s"})
    for (const float scale : {1.0F, 1.5F, 2.0F}) {
      DiagramSheet sheet = sheetOf({{0, 0}, {4, 2}});
      sheet.diagrams.front().series.front().stroke = SeriesStroke::None;
      sheet.diagrams.front().marker = DiagramMarker{"this line, now", text};
      sheet.diagrams.front().marker->x = 0.5;
      sheet.diagrams.front().marker->y = 0.9;
      const DrawList list = composeDiagrams(sheet, {1660, 720, scale, printTheme()});
      const DrawText* name = textOf(list, text);
      ASSERT_TRUE(name) << text;
      EXPECT_FALSE(same(name->colour, printTheme().text)) << "not as a curve's name";
      const float half = textWidth(name->utf8, name->size) / 2;
      constexpr std::size_t kRingVertices = 33;
      int rings = 0;
      for (const DrawLine& line : linesOf(list, seriesColour(kMarkerColour, printTheme()))) {
        if (line.vertices.size() != kRingVertices) continue;
        ++rings;
        for (const DrawVertex& v : line.vertices) {
          const bool isBeside = v.x + line.width / 2 < name->x - half - 1 ||
                                v.x - line.width / 2 > name->x + half + 1;
          const bool isAside = v.y + line.width / 2 < name->y - name->size ||
                               v.y - line.width / 2 > name->y + 0.3F * name->size;
          EXPECT_TRUE(isBeside || isAside) << text << " " << scale;
        }
      }
      EXPECT_EQ(rings, 1);
    }
}

/// A legend beside one of several diagrams would make it narrower than the others.
TEST(DiagramDrawing, DiagramsInARowAreEquallyWide) {
  DiagramSheet sheet;
  for (const char* name : {"moduli (Pa)", "loss tangent", "share"}) {
    Diagram diagram = sheetOf({{0, 1}, {1, 2}, {2, 3}}).diagrams.front();
    diagram.y.title = name;
    sheet.diagrams.push_back(diagram);
  }
  // The curves of the first leave no corner free.
  DiagramSeries falling = sheet.diagrams[0].series[0], middle = falling;
  falling.points = {{0, 3}, {1, 2}, {2, 1}};
  middle.points = {{0, 2}, {1, 2}, {2, 2}};
  sheet.diagrams[0].series[0].name = "G1";
  falling.name = "G2";
  sheet.diagrams[0].series.push_back(falling);
  sheet.diagrams[0].series.push_back(middle);
  DiagramOptions options{1120, 200, 1, lightTheme()};
  options.minTextSize = 1;
  const std::vector<ChartGeometry> frames = diagramFrames(sheet, options);
  ASSERT_EQ(frames.size(), 3U);
  for (const ChartGeometry& frame : frames) {
    EXPECT_NEAR(frame.area.width(), frames[0].area.width(), 2);
    EXPECT_EQ(frame.area.top(), frames[0].area.top());
  }
}

TEST(DiagramDrawing, DiagramsOfASheetAreEquallyHigh) {
  const DrawList list = composeDiagrams(figureSheets()[3].sheet, {2400, 1100, 2, lightTheme()});
  std::vector<float> tops, bottoms;
  for (const DrawLayer& layer : list.layers)
    if (layer.clip.width > 0) {
      tops.push_back(layer.clip.y);
      bottoms.push_back(layer.clip.y + layer.clip.height);
    }
  ASSERT_GE(tops.size(), 4U);
  EXPECT_EQ(*std::min_element(tops.begin(), tops.end()),
            *std::max_element(tops.begin(), tops.end()));
  EXPECT_EQ(*std::min_element(bottoms.begin(), bottoms.end()),
            *std::max_element(bottoms.begin(), bottoms.end()));
}

/// Long curves are thinned to the pixels, so the cost does not grow with the points.
TEST(DiagramDrawing, LongCurvesAreThinned) {
  std::vector<DiagramPoint> points;
  for (int i = 0; i < 200000; ++i) points.push_back({i * 1e-5, std::sin(i * 0.01)});
  DiagramSheet sheet = unnamed(sheetOf(points));
  sheet.diagrams[0].series[0].mark = SeriesMark::None;
  std::size_t vertices = 0;
  const DrawList list = composeDiagrams(sheet, {});
  for (const DrawLine& line : linesOf(list, seriesColour(0, lightTheme())))
    vertices += line.vertices.size();
  EXPECT_LE(vertices, 2U * 1200 + 4);
  EXPECT_GT(vertices, 1000U);
}

/// A single number does not show the scale of a strip.
TEST(DiagramDrawing, TheAxisOfAStripHasTwoNumbers) {
  const DiagramSizes sizes;
  for (const AxisScale scale : {AxisScale::Linear, AxisScale::Logarithmic})
    for (const float letters : {2.8F, 3.0F, 5.0F})
      for (double from = -3.1; from < 0; from += 0.07)
        for (const double size : {0.2, 0.37, 0.6, 1.0, 1.3, 1.9, 2.6, 4.0}) {
          const AxisRange range{from, from + size};
          const TickedAxis axis = tickedYAxis({"y", "", scale}, range, letters * sizes.tick, sizes);
          ASSERT_GE(axis.ticks.size(), 2U) << static_cast<int>(scale) << ' ' << letters
                                           << " letters, " << range.from << " to " << range.to;
          const double apart = (axis.ticks[1].value - axis.ticks[0].value) / size;
          EXPECT_GE(apart * letters, 0.999) << "labels must not touch";
        }
}

/// Three numbers show it better, wherever the diagram is high enough: 12 lines of text for the
/// steps of a linear axis, 8 for decades.
TEST(DiagramDrawing, TheAxisOfADiagramHasThreeNumbers) {
  const DiagramSizes sizes;
  const auto ticks = [&](AxisScale scale, const AxisRange& range, float letters) {
    return tickedYAxis({"y", "", scale}, range, letters * sizes.tick, sizes).ticks;
  };
  for (const auto& [scale, letters] :
       {std::pair{AxisScale::Linear, 12.0F}, std::pair{AxisScale::Logarithmic, 8.0F}})
    for (double from = -3.1; from < 0; from += 0.07)
      for (const double size : {1.0, 1.3, 1.7, 1.9, 2.6, 4.0}) {
        const std::vector<Tick> found = ticks(scale, {from, from + size}, letters);
        EXPECT_GE(found.size(), 3U)
            << static_cast<int>(scale) << ' ' << from << " to " << from + size;
        for (std::size_t i = 1; i < found.size(); ++i)
          EXPECT_GE((found[i].value - found[i - 1].value) / size * letters, 1.2);
      }
  // The loss tangent in a window of 1024 pixels, and the frequencies below it.
  EXPECT_EQ(ticks(AxisScale::Logarithmic, {-1, std::log10(0.5)}, 5.2F).size(), 3U);
  EXPECT_EQ(ticks(AxisScale::Logarithmic, {-1, std::log10(0.49)}, 8).size(), 4U);
  const DiagramAxis frequency{"f", "Hz", AxisScale::Logarithmic};
  EXPECT_EQ(tickedXAxis(frequency, {0.7, 5.5}, 12 * sizes.tick, sizes).ticks.size(), 3U);
  // Names stand above the frame, and numbers below it would mean nothing.
  const DiagramAxis names{"parameter", "", AxisScale::Linear, 0.5, 2.5, true};
  EXPECT_TRUE(tickedXAxis(names, {0.5, 2.5}, 40 * sizes.tick, sizes).ticks.empty());
}

/// Returns whether the numbers at two of the positions 1, 2 and 5 times powers of ten fit beside
/// each other below an axis.
bool hasSpaceForTwo(const AxisRange& range, float pixels, float size) {
  const std::vector<Tick> ticks = logTicks(range.from, range.to, 100);
  for (std::size_t i = 0; i < ticks.size(); ++i)
    for (std::size_t k = i + 1; k < ticks.size(); ++k) {
      const double apart = (ticks[k].value - ticks[i].value) / range.size() * pixels;
      const double labels = textWidth(ticks[i].label, size) + textWidth(ticks[k].label, size);
      if (apart > 0.5 * labels + 0.8 * size) return true;
    }
  return false;
}

/// Nor does it below a narrow diagram.
TEST(DiagramDrawing, TheAxisBelowANarrowDiagramHasTwoNumbers) {
  const DiagramSizes sizes;
  int count = 0;
  for (const float letters : {4.0F, 4.5F, 5.0F, 6.0F, 8.0F, 12.0F})
    for (double from = -3.1; from < 0; from += 0.07)
      for (const double size : {0.2, 0.37, 0.6, 1.0, 1.3, 1.9, 2.6, 4.0, 7.0}) {
        const AxisRange range{from, from + size};
        const float pixels = letters * sizes.tick;
        const TickedAxis axis =
            tickedXAxis({"x", "", AxisScale::Logarithmic}, range, pixels, sizes);
        for (std::size_t i = 0; i + 1 < axis.ticks.size(); ++i) {
          const double apart =
              (axis.ticks[i + 1].value - axis.ticks[i].value) / size * static_cast<double>(pixels);
          EXPECT_GT(apart, 0.5 * (textWidth(axis.ticks[i].label, sizes.tick) +
                                  textWidth(axis.ticks[i + 1].label, sizes.tick)))
              << "labels must not touch";
        }
        EXPECT_GE(axis.ticks.size(), hasSpaceForTwo(range, pixels, sizes.tick) ? 2U : 1U)
            << letters << " letters, " << range.from << " to " << range.to;
        ++count;
      }
  EXPECT_GT(count, 1000);
}

/// The sentence that says why there is no curve is not crossed by the line of the present state.
/// The axis is that of the significant bars; a longer interval ends in an arrow at the frame.
TEST(DiagramDrawing, AnIntervalBeyondTheAxisEndsInAnArrow) {
  DiagramSheet sheet;
  Diagram& diagram = sheet.diagrams.emplace_back();
  diagram.x = {"exponent", "", AxisScale::Linear, -0.2, 1};
  diagram.y = {"", "", AxisScale::Linear};
  diagram.bars = {{"force", 0.5, 0.1}, {"seed", 0.1, 5}};
  const Theme theme = printTheme();
  const DrawList list = composeDiagrams(sheet, {.theme = theme});
  const QRectF frame = diagramFrames(sheet, {.theme = theme}).front().area;
  std::size_t heads = 0;
  for (const DrawLine& line : linesOf(list, theme.faintText)) {
    heads += line.vertices.size() == 3;
    for (const DrawVertex& vertex : line.vertices) {
      EXPECT_GE(vertex.x, frame.left() - 1);
      EXPECT_LE(vertex.x, frame.right() + 1);
    }
  }
  EXPECT_EQ(heads, 2U);
}

/// A trace whose friction changes its direction comes as close to 0 as one looks.
TEST(DiagramDrawing, TheTraceOfAMarkerLeavesTheAxisAlone) {
  DiagramSheet sheet = unnamed(sheetOf({{0.1, 1e-3}, {10, 1e-2}}));
  Diagram& diagram = sheet.diagrams[0];
  diagram.x.scale = diagram.y.scale = AxisScale::Logarithmic;
  diagram.marker = DiagramMarker{{}, "v", 1, 2e-3};
  const auto points = [&] {
    return dotsOf(composeDiagrams(sheet, {}), seriesColour(0, lightTheme()));
  };
  const std::vector<DrawVertex> before = points();
  diagram.marker->trace = {{1, 2e-3}, {1.1, 1e-9}, {1.2, 0}, {1.3, 1e-4}};
  const std::vector<DrawVertex> after = points();
  ASSERT_EQ(before.size(), 2U);
  ASSERT_EQ(after.size(), 2U);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(after[i].y, before[i].y, 0.01);
}

TEST(DiagramDrawing, TheLineOfTheMarkerDoesNotCrossTheSentence) {
  DiagramSheet sheet;
  Diagram diagram;
  diagram.x = {"x", "", AxisScale::Logarithmic, 1e-3, 1e3};
  diagram.y = {"y", "", AxisScale::Logarithmic, 1e-3, 1};
  diagram.blank = "There is no friction here.";
  diagram.marker = DiagramMarker{"now", "v", 1, 1e-9};
  sheet.diagrams = {diagram};
  DiagramOptions options;
  const DrawList list = composeDiagrams(sheet, options);
  const DrawText* sentence = textOf(list, "There is no friction here.");
  ASSERT_TRUE(sentence);
  int upright = 0;
  for (const DrawLine& line : linesOf(list, seriesColour(1, options.theme))) {
    const DrawVertex &a = line.vertices.front(), &b = line.vertices.back();
    if (a.x != b.x) continue;
    ++upright;
    EXPECT_TRUE(std::max(a.y, b.y) < sentence->y - sentence->size ||
                std::min(a.y, b.y) > sentence->y + 0.3F * sentence->size);
  }
  EXPECT_EQ(upright, 2);
}

}  // namespace
}  // namespace asperity
