// What vector files (SVG, PDF) are made of: paths of shapes, gradients and fills.
#pragma once

#include <vector>

#include "ui/draw/draw_list.h"
#include "ui/draw/stroke_pattern.h"

namespace asperity {

/// One colour, or a linear change from `from` at `start` to `to` at `end`.
struct VectorPaint {
  Rgba from, to;
  Place start, end;
  bool isGradient = false;
};

/// Closed outlines that are filled together by the non-zero rule.
struct VectorFill {
  VectorPaint paint;
  std::vector<Polyline> outlines;
  /// One piece of many that abut: smooth edges would let what lies below shine through.
  bool isPieceOfMesh = false;
};

/// Polylines drawn by one pen; one of a single place is a round dot.
struct VectorStroke {
  Rgba colour;
  float width = 1;
  std::vector<Polyline> lines;
};

struct VectorLayer {
  Clip clip;
  std::vector<VectorFill> fills;      // first is lowest
  std::vector<VectorStroke> strokes;  // over the fills
};

/// Triangles in a row that share a paint become one fill, without the edges between them; lines in
/// a row that share an opaque pen become one stroke; a line splits where its colour changes, or has
/// the mean of its colours where it is translucent.
VectorLayer vectorized(const DrawLayer& layer);

/// The outline of triangles that are all turned the same way: edges that two of them share are
/// left out. Winding numbers stay what they were.
std::vector<Polyline> outlineOf(const std::vector<Place>& corners);

std::vector<VectorFill> fillsOf(const std::vector<DrawVertex>& triangles);

bool isDrawable(const DrawVertex& vertex);  // finite
/// The same in eight bits a channel.
bool sameColour(const Rgba& a, const Rgba& b);

}  // namespace asperity
