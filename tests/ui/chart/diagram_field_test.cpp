// The values that are written along contour lines.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "ui/chart/diagram_picture.h"

namespace asperity {
namespace {

constexpr int kSide = 800;  // pixels of the picture

/// Returns a field over the unit square with one contour of these lines, and a dashed border.
DrawList drawnField(std::vector<std::vector<DiagramPoint>> lines,
                    std::vector<DiagramPoint> border) {
  Diagram diagram;
  diagram.x = {"x", "m", AxisScale::Linear, 0, 1};
  diagram.y = {"y", "m", AxisScale::Linear, 0, 1};
  diagram.field = DiagramField{.colours = {"height", "m", AxisScale::Linear, 0, 1},
                               .x = {0, 1},
                               .y = {0, 1},
                               .values = {0, 1, 0, 1},
                               .contours = {{0.5, Message::name("0.123"), std::move(lines)}}};
  diagram.series.push_back({.stroke = SeriesStroke::Dashed, .points = std::move(border)});
  DiagramSheet sheet;
  sheet.diagrams.push_back(std::move(diagram));
  return composeDiagrams(sheet, {kSide, kSide, 1, lightTheme()});
}

std::vector<DrawText> valuesOn(const DrawList& list) {
  std::vector<DrawText> values;
  for (const DrawText& text : list.texts)
    if (text.utf8 == "0.123") values.push_back(text);
  return values;
}

/// A border runs along the contour, which leaves it near its upper end alone: there is the value.
TEST(DiagramField, AValueKeepsAwayFromBorders) {
  const DrawList list = drawnField({{{0.5, 0}, {0.5, 0.75}, {0.5, 1}}},
                                   {{0.5, 0}, {0.5, 0.75}, {0.6, 0.8}, {0.6, 1}});
  const std::vector<DrawText> values = valuesOn(list);
  ASSERT_EQ(values.size(), 1U);
  EXPECT_LT(values[0].y, 0.25F * kSide);
}

/// Of two lines of a contour, the one without a free place has no value.
TEST(DiagramField, ALineAlongABorderNeedsNoSecondValue) {
  const std::vector<DiagramPoint> along{{0.3, 0}, {0.3, 1}}, free{{0.8, 0}, {0.8, 0.9}};
  const std::vector<DrawText> values = valuesOn(drawnField({along, free}, along));
  ASSERT_EQ(values.size(), 1U);
  EXPECT_GT(values[0].x, 0.5F * kSide);
}

/// A contour whose only line runs along a border has its value there rather than nowhere.
TEST(DiagramField, EveryContourHasItsValue) {
  const std::vector<DiagramPoint> along{{0.3, 0}, {0.3, 1}};
  EXPECT_EQ(valuesOn(drawnField({along}, along)).size(), 1U);
}

}  // namespace
}  // namespace asperity
