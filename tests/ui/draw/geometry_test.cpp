#include "ui/draw/shapes.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/ui/draw/drawing.h"

namespace asperity {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Geometry flattened(const DrawList& list) {
  Geometry geometry;
  flatten(list, geometry);
  return geometry;
}

TEST(Geometry, OneSegmentForEachPairOfVertices) {
  DrawList list = blackList(10, 10);
  DrawLayer layer;
  layer.lines.push_back({{{0, 0, kRed}, {1, 1, kRed}, {2, 0, kRed}}, 1});
  layer.lines.push_back({{{5, 5, kRed}}, 3});
  layer.triangles = rectangle(0, 0, 1, 1, kRed);
  list.layers.push_back(layer);
  const Geometry geometry = flattened(list);
  ASSERT_EQ(geometry.batches.size(), 1U);
  EXPECT_EQ(geometry.batches[0].segments, 3U);  // two, and one for the dot
  EXPECT_EQ(geometry.batches[0].triangleCorners, 6U);
  EXPECT_EQ(geometry.data.size(), 6U * kTriangleFloats + 3U * kSegmentFloats);
}

TEST(Geometry, LeavesOutWhatIsNotFinite) {
  DrawList list = blackList(10, 10);
  DrawLayer layer;
  layer.triangles = rectangle(0, kNan, 1, 1, kRed);
  layer.lines.push_back({{{0, 0, kRed}, {kNan, 1, kRed}, {2, 0, kRed}, {2, 0, kRed}}, 1});
  layer.lines.push_back({{{0, 0, kRed}, {1, 1, kRed}}, kNan});
  layer.lines.push_back({});
  list.layers.push_back(layer);
  const Geometry geometry = flattened(list);
  EXPECT_EQ(geometry.batches[0].triangleCorners, 0U);
  EXPECT_EQ(geometry.batches[0].segments, 1U);
}

TEST(Geometry, ClipBecomesPixelsFromTheLowerLeft) {
  DrawList list = blackList(100, 50);
  DrawLayer layer;
  layer.clip = {10, 5, 20, 10};
  list.layers.push_back(layer);
  layer.clip = {-10, -10, 1000, 1000};
  list.layers.push_back(layer);
  layer.clip = {200, 0, 10, 10};
  list.layers.push_back(layer);
  const Geometry geometry = flattened(list);
  const ScissorBox& inside = geometry.batches[0].scissor;
  EXPECT_EQ(inside.x, 10);
  EXPECT_EQ(inside.y, 35);
  EXPECT_EQ(inside.width, 20);
  EXPECT_EQ(inside.height, 10);
  EXPECT_EQ(geometry.batches[1].scissor.width, 100);
  EXPECT_EQ(geometry.batches[1].scissor.height, 50);
  EXPECT_EQ(geometry.batches[2].scissor.width, 0);
}

}  // namespace
}  // namespace asperity
