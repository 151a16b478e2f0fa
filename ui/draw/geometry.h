// A DrawList flattened for the graphics card: one array of floats and, for each layer, which part
// of it to draw. Pure, knows no OpenGL; any thread. Shapes with a coordinate that is not finite are
// left out.
#pragma once

#include <cstddef>
#include <vector>

#include "ui/draw/draw_list.h"

namespace asperity {

inline constexpr int kTriangleFloats = 6;  // x y r g b a, a corner
inline constexpr int kSegmentFloats = 17;  // ends (4), neighbours (4), two colours (8), width

/// Whole pixels, origin bottom left as OpenGL counts.
struct ScissorBox {
  int x = 0, y = 0, width = 0, height = 0;
};

/// One layer: triangles first, then segments. Offsets count floats from the start of the data.
struct DrawBatch {
  ScissorBox scissor;
  std::size_t triangleOffset = 0, triangleCorners = 0;
  std::size_t segmentOffset = 0, segments = 0;
};

struct Geometry {
  std::vector<float> data;
  std::vector<DrawBatch> batches;
};

/// Fills `geometry`, reusing its memory.
void flatten(const DrawList& list, Geometry& geometry);

}  // namespace asperity
