// What triangles and lines look like, pixel by pixel: as the program's own rasterizer draws them,
// and as OpenGL does.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/ui/draw/drawing.h"

namespace asperity {
namespace {

class ShapesOnScreen : public testing::TestWithParam<PixelBackend> {
 protected:
  Pixels drawn(const DrawList& list) { return makePixelContext(GetParam())->draw(list); }

  Pixels drawn(const DrawLayer& layer, int width, int height) {
    DrawList list = blackList(width, height);
    list.layers.push_back(layer);
    return drawn(list);
  }

  Pixels drawn(const DrawLine& line, int width, int height) {
    DrawLayer layer;
    layer.lines.push_back(line);
    return drawn(layer, width, height);
  }
};

INSTANTIATE_TEST_SUITE_P(Backends, ShapesOnScreen,
                         testing::Values(PixelBackend::Raster, PixelBackend::Osmesa),
                         [](const auto& backend) {
                           // A context of OpenGL would take 0.1 s in every test of this program.
                           return backend.param == PixelBackend::Raster ? "raster" : "osmesa";
                         });

TEST_P(ShapesOnScreen, TheBackendIsTheOneOfTheName) {
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  EXPECT_TRUE(name.ends_with("/" + makePixelContext(GetParam())->name())) << name;
}

TEST_P(ShapesOnScreen, RowsStartAtTheTop) {
  DrawLayer layer;
  layer.triangles = rectangle(2, 1, 3, 4, kWhite);
  const Pixels pixels = drawn(layer, 20, 10);
  EXPECT_DOUBLE_EQ(coverage(pixels), 12);
  EXPECT_EQ(red(pixels, 2, 1), 255);
  EXPECT_EQ(red(pixels, 4, 4), 255);
  EXPECT_EQ(red(pixels, 5, 4), 0);
  EXPECT_EQ(red(pixels, 2, 0), 0);
  EXPECT_EQ(red(pixels, 2, 8), 0);
}

TEST_P(ShapesOnScreen, TriangleCoversHalfItsBox) {
  DrawLayer layer;
  layer.triangles = {{0, 0, kWhite}, {100, 0, kWhite}, {0, 100, kWhite}};
  EXPECT_NEAR(coverage(drawn(layer, 100, 100)), 5000, 60);
}

TEST_P(ShapesOnScreen, ColoursBlendBetweenCorners) {
  DrawLayer layer;
  layer.triangles = {{0, 0, kBlack}, {256, 0, kWhite}, {256, 4, kWhite},
                     {0, 0, kBlack}, {256, 4, kWhite}, {0, 4, kBlack}};
  const Pixels pixels = drawn(layer, 256, 4);
  for (const int x : {0, 64, 128, 255}) EXPECT_NEAR(red(pixels, x, 2), x, 1.1);
}

TEST_P(ShapesOnScreen, LineHasItsWidthAndRoundEnds) {
  const Pixels pixels = drawn(straight(10, 20, 50, 20, 6, kWhite), 60, 40);
  for (int y = 17; y < 23; ++y) EXPECT_EQ(red(pixels, 30, y), 255) << y;
  EXPECT_EQ(red(pixels, 30, 16), 0);
  EXPECT_EQ(red(pixels, 30, 23), 0);
  EXPECT_EQ(red(pixels, 51, 19), 255);
  EXPECT_NEAR(coverage(pixels), 40 * 6 + std::numbers::pi * 9, 1.5);
}

TEST_P(ShapesOnScreen, SmoothEdgesKeepTheAreaAtAnyAngle) {
  for (const double angle : {0.1, 0.5, 0.7854, 1.2, 2.0}) {
    const auto dx = static_cast<float>(40 * std::cos(angle));
    const auto dy = static_cast<float>(40 * std::sin(angle));
    const Pixels pixels = drawn(straight(50 - dx, 50 - dy, 50 + dx, 50 + dy, 3, kWhite), 100, 100);
    EXPECT_NEAR(coverage(pixels), 80 * 3 + std::numbers::pi * 2.25, 5) << angle;
  }
}

TEST_P(ShapesOnScreen, HalfAPixelIsHalfAsBright) {
  const Pixels between = drawn(straight(-5, 10, 30, 10, 1, kWhite), 20, 20);
  EXPECT_NEAR(red(between, 10, 9), 128, 1);
  EXPECT_NEAR(red(between, 10, 10), 128, 1);
  const Pixels thin = drawn(straight(-5, 10.5F, 30, 10.5F, 0.5F, kWhite), 20, 20);
  EXPECT_NEAR(red(thin, 10, 10), 128, 1);
}

TEST_P(ShapesOnScreen, AlphaBlendsOverWhatIsThere) {
  DrawLayer layer;
  layer.triangles = rectangle(0, 0, 4, 4, kWhite);
  const auto over = rectangle(0, 0, 4, 4, {1, 0, 0, 0.25F});
  layer.triangles.insert(layer.triangles.end(), over.begin(), over.end());
  const auto colour = pixel(drawn(layer, 4, 4), 1, 1);
  EXPECT_EQ(colour[0], 255);
  EXPECT_NEAR(colour[1], 191, 1);
  EXPECT_EQ(colour[3], 255);
}

TEST_P(ShapesOnScreen, TranslucentJoinsDoNotBlendTwice) {
  const Rgba half{1, 1, 1, 0.5F};
  DrawLine zigzag{{}, 9};
  for (int i = 0; i < 12; ++i)
    zigzag.vertices.push_back(
        {10.0F + 9 * static_cast<float>(i), i % 2 == 0 ? 30.0F : 60.3F, half});
  const Pixels pixels = drawn(zigzag, 120, 90);
  int brightest = 0;
  for (int y = 20; y < 38; ++y)
    for (int x = 6; x < 14; ++x) brightest = std::max(brightest, red(pixels, x, y));
  EXPECT_NEAR(brightest, 128, 1);
  // A right angle has its full area once: two bars and the round corner.
  const DrawLine corner{{{20, 20, half}, {60, 20, half}, {60, 60, half}}, 8};
  const Pixels bent = drawn(corner, 80, 80);
  for (std::size_t i = 0; i < bent.rgba.size(); i += 4) ASSERT_LE(bent.rgba[i], 128);
  const double quarter = std::numbers::pi * 16 / 4;
  EXPECT_NEAR(coverage(bent), 0.5 * (2 * 40 * 8 - 16 + quarter + std::numbers::pi * 16), 3);
}

TEST_P(ShapesOnScreen, RepeatedVerticesChangeNothing) {
  const DrawLine once{{{5, 5, kWhite}, {30, 12, kWhite}, {40, 33, kWhite}}, 5};
  const DrawLine twice{
      {{5, 5, kWhite}, {5, 5, kWhite}, {30, 12, kWhite}, {30, 12, kWhite}, {40, 33, kWhite}}, 5};
  EXPECT_EQ(drawn(once, 50, 50).rgba, drawn(twice, 50, 50).rgba);
}

TEST_P(ShapesOnScreen, ClipHoldsShapesBack) {
  DrawLayer layer;
  layer.clip = {10, 4, 6, 5};
  layer.triangles = rectangle(0, 0, 30, 30, kWhite);
  layer.lines.push_back(straight(0, 0, 30, 30, 5, kWhite));
  const Pixels pixels = drawn(layer, 30, 30);
  EXPECT_DOUBLE_EQ(coverage(pixels), 30);
  EXPECT_EQ(red(pixels, 10, 4), 255);
  EXPECT_EQ(red(pixels, 15, 8), 255);
  EXPECT_EQ(red(pixels, 9, 4), 0);
  EXPECT_EQ(red(pixels, 10, 9), 0);
}

TEST_P(ShapesOnScreen, LaterLayersAndLinesLieOnTop) {
  DrawList list = blackList(10, 10);
  DrawLayer below, above;
  below.triangles = rectangle(0, 0, 10, 10, kRed);
  below.lines.push_back(straight(0, 5, 10, 5, 4, kWhite));
  above.triangles = rectangle(0, 0, 5, 10, kBlack);
  list.layers = {below, above};
  const Pixels pixels = drawn(list);
  EXPECT_EQ(pixel(pixels, 7, 5), (std::array<int, 4>{255, 255, 255, 255}));
  EXPECT_EQ(pixel(pixels, 7, 1), (std::array<int, 4>{255, 0, 0, 255}));
  EXPECT_EQ(pixel(pixels, 2, 5), (std::array<int, 4>{0, 0, 0, 255}));
}

TEST_P(ShapesOnScreen, ClearBackgroundStaysClear) {
  DrawList list = blackList(8, 8);
  list.background = {1, 1, 1, 0};
  DrawLayer layer;
  layer.triangles = rectangle(0, 0, 4, 8, {1, 0, 0, 0.5F});
  list.layers.push_back(layer);
  const Pixels pixels = drawn(list);
  EXPECT_EQ(pixel(pixels, 6, 4), (std::array<int, 4>{0, 0, 0, 0}));
  EXPECT_NEAR(pixel(pixels, 1, 4)[0], 128, 1);  // premultiplied
  EXPECT_NEAR(pixel(pixels, 1, 4)[3], 128, 1);
}

/// A fan of triangles around a point covers each pixel once: where two triangles meet there is
/// neither a gap nor a pixel drawn twice, wherever the corners lie.
TEST_P(ShapesOnScreen, NeighboursShareNoPixelAndLeaveNone) {
  const Rgba half{1, 1, 1, 0.5F};
  for (int turn = 0; turn < 20; ++turn) {
    DrawLayer layer;
    const auto corner = [&](int i) {
      const double angle = 2 * std::numbers::pi * (i + 0.05 * turn) / 13;
      return DrawVertex{static_cast<float>(40.3 + 60 * std::cos(angle)),
                        static_cast<float>(39.9 + 60 * std::sin(angle)), half};
    };
    const DrawVertex middle{40.3F + 0.17F * static_cast<float>(turn), 39.5F, half};
    for (int i = 0; i < 13; ++i)
      layer.triangles.insert(layer.triangles.end(), {corner(i), corner(i + 1), middle});
    const Pixels pixels = drawn(layer, 80, 80);
    for (int y = 0; y < 80; ++y)
      for (int x = 0; x < 80; ++x) ASSERT_NEAR(red(pixels, x, y), 128, 1) << x << " " << y;
  }
}

TEST_P(ShapesOnScreen, WhatLiesOutsideOrHasNoAreaIsHarmless) {
  DrawLayer layer;
  layer.triangles = {{-1e7F, -1e7F, kWhite}, {1e7F, -1e7F, kWhite}, {3, -1e6F, kWhite},
                     {2, 2, kWhite},         {6, 6, kWhite},        {9, 9, kWhite},
                     {5, 5, kWhite},         {5, 5, kWhite},        {5, 5, kWhite}};
  layer.lines = {straight(-1e6F, -50, 1e6F, -50, 3, kWhite), straight(400, 3, 500, 9, 3, kWhite)};
  EXPECT_EQ(coverage(drawn(layer, 20, 20)), 0);
}

}  // namespace
}  // namespace asperity
