#include "ui/draw/vector_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ui/draw/shapes.h"

namespace asperity {
namespace {

constexpr Rgba kRed{1, 0, 0, 1}, kBlue{0, 0, 1, 1}, kClear{1, 0, 0, 0};

double areaOf(const Polyline& outline) {
  double area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const DrawPoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
    area += (static_cast<double>(a.x) * b.y - static_cast<double>(b.x) * a.y) / 2;
  }
  return area;
}

double areaOf(const std::vector<Polyline>& outlines) {
  double area = 0;
  for (const Polyline& outline : outlines) area += areaOf(outline);
  return area;
}

TEST(Outline, OfAStripHasNoInnerEdges) {
  DrawLayer layer;
  const auto height = [](int i) { return static_cast<float>(10 + (i * 7) % 5); };
  double area = 0;
  for (int i = 0; i < 50; ++i) {
    const auto x = static_cast<float>(i);
    addQuad(layer, {x, height(i), kRed}, {x + 1, height(i + 1), kRed}, {x + 1, 30, kRed},
            {x, 30, kRed});
    area += 30 - (height(i) + height(i + 1)) / 2;
  }
  const VectorLayer vector = vectorized(layer);
  ASSERT_EQ(vector.fills.size(), 1U);
  ASSERT_EQ(vector.fills[0].outlines.size(), 1U);
  EXPECT_EQ(vector.fills[0].outlines[0].size(), 102U);
  EXPECT_NEAR(areaOf(vector.fills[0].outlines), area, 1e-3);
  EXPECT_FALSE(vector.fills[0].isPieceOfMesh);
}

/// Corners given one way round or the other fill alike: never a hole.
TEST(Outline, TrianglesAreTurnedTheSameWay) {
  DrawLayer layer;
  layer.triangles = {{0, 0, kRed},  {10, 0, kRed}, {0, 10, kRed},
                     {10, 0, kRed}, {0, 10, kRed}, {10, 10, kRed}};
  const VectorLayer vector = vectorized(layer);
  ASSERT_EQ(vector.fills.size(), 1U);
  ASSERT_EQ(vector.fills[0].outlines.size(), 1U);
  EXPECT_EQ(vector.fills[0].outlines[0].size(), 4U);
  EXPECT_NEAR(std::abs(areaOf(vector.fills[0].outlines)), 100, 1e-6);
}

TEST(VectorShapes, ColoursStartNewFillsInTheirOrder) {
  DrawLayer layer;
  addRectangle(layer, {0, 0, 10, 10}, kRed);
  addRectangle(layer, {5, 5, 10, 10}, kBlue);
  addRectangle(layer, {8, 8, 10, 10}, kRed);
  const VectorLayer vector = vectorized(layer);
  ASSERT_EQ(vector.fills.size(), 3U);
  EXPECT_EQ(vector.fills[0].paint.from.r, 1);
  EXPECT_EQ(vector.fills[1].paint.from.b, 1);
}

TEST(VectorShapes, ALinearChangeIsOneGradient) {
  DrawLayer layer;
  addRectangle(layer, {0, 20, 50, 80}, kRed, kBlue);
  const VectorLayer vector = vectorized(layer);
  ASSERT_EQ(vector.fills.size(), 1U);
  const VectorPaint& paint = vector.fills[0].paint;
  ASSERT_TRUE(paint.isGradient);
  const bool down = paint.start.y < paint.end.y;
  EXPECT_NEAR(down ? paint.start.y : paint.end.y, 20, 1e-3);
  EXPECT_NEAR(down ? paint.end.y : paint.start.y, 100, 1e-3);
  EXPECT_NEAR((down ? paint.from : paint.to).r, 1, 1e-3);
  EXPECT_NEAR((down ? paint.to : paint.from).b, 1, 1e-3);
}

/// Three unlike corners: pieces that cover the triangle exactly, each of its colour there.
TEST(VectorShapes, AnyOtherChangeIsPieces) {
  DrawLayer layer;
  layer.triangles = {{0, 0, kRed}, {80, 0, {0, 1, 0, 1}}, {0, 80, kBlue}};
  const VectorLayer vector = vectorized(layer);
  EXPECT_GT(vector.fills.size(), 50U);
  double area = 0;
  for (const VectorFill& fill : vector.fills) {
    EXPECT_TRUE(fill.isPieceOfMesh);
    area += areaOf(fill.outlines);
    const DrawPoint& corner = fill.outlines[0][0];
    EXPECT_NEAR(fill.paint.from.g, corner.x / 80, 0.1);
    EXPECT_NEAR(fill.paint.from.b, corner.y / 80, 0.1);
  }
  EXPECT_NEAR(area, 3200, 0.01);
}

TEST(VectorShapes, WhatCannotBeSeenIsLeftOut) {
  DrawLayer layer;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  addRectangle(layer, {0, 0, 10, 10}, kClear);
  addRectangle(layer, {nan, 0, 10, 10}, kRed);
  addRectangle(layer, {0, 0, 10, 0}, kRed);
  addLine(layer, {{nan, nan}}, 2, kRed);
  addLine(layer, {{0, 0}, {1, 1}}, 0, kRed);
  const VectorLayer vector = vectorized(layer);
  EXPECT_TRUE(vector.fills.empty());
  EXPECT_TRUE(vector.strokes.empty());
}

TEST(VectorShapes, LinesOfOnePenAreOneStroke) {
  DrawLayer layer;
  addLine(layer, {{0, 0}, {5, 5}, {9, 0}}, 2, kRed);
  addLine(layer, {{0, 9}, {5, 9}}, 2, kRed);
  addLine(layer, {{3, 3}}, 2, kRed);
  addLine(layer, {{0, 9}, {5, 9}}, 3, kRed);
  addLine(layer, {{0, 9}, {5, 9}}, 3, kBlue);
  const VectorLayer vector = vectorized(layer);
  ASSERT_EQ(vector.strokes.size(), 3U);
  ASSERT_EQ(vector.strokes[0].lines.size(), 3U);
  EXPECT_EQ(vector.strokes[0].lines[0].size(), 3U);
  EXPECT_EQ(vector.strokes[0].lines[2].size(), 1U);
}

/// Translucent lines that cross would be darker where they do; in one stroke they would not.
TEST(VectorShapes, TranslucentLinesStayApart) {
  DrawLayer layer;
  const Rgba faint{1, 0, 0, 0.5F};
  addLine(layer, {{0, 0}, {5, 5}}, 2, faint);
  addLine(layer, {{0, 5}, {5, 0}}, 2, faint);
  EXPECT_EQ(vectorized(layer).strokes.size(), 2U);
}

TEST(VectorShapes, ALineSplitsWhereItsColourChanges) {
  DrawLayer layer;
  layer.lines.push_back({{{0, 0, kRed}, {10, 0, kRed}, {20, 0, kBlue}, {30, 0, kBlue}}, 2});
  const VectorLayer vector = vectorized(layer);
  ASSERT_GT(vector.strokes.size(), 5U);
  float at = 0;  // no gap between the pieces
  for (const VectorStroke& stroke : vector.strokes)
    for (const Polyline& line : stroke.lines) {
      EXPECT_FLOAT_EQ(line.front().x, at);
      at = line.back().x;
    }
  EXPECT_FLOAT_EQ(at, 30);
  EXPECT_NEAR(vector.strokes.front().colour.r, 1, 0.07);
  EXPECT_NEAR(vector.strokes.back().colour.b, 1, 0.07);
}

}  // namespace
}  // namespace asperity
