// Shapes and texts appended to a DrawLayer or a DrawList, polylines cut at the edges of a box or
// into dashes, whole pictures in a picture, and the shapes of a DrawList as numbers for those who
// draw them. Pure; any thread. Pixels, y down.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "ui/draw/draw_list.h"

namespace asperity {

struct DrawPoint {
  float x = 0, y = 0;
};
using Polyline = std::vector<DrawPoint>;

/// For a DrawPoint or a DrawVertex.
template <class Point>
bool isFinite(const Point& point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}
template <class Point>
bool isSamePoint(const Point& a, const Point& b) {
  return a.x == b.x && a.y == b.y;
}

void addRectangle(DrawLayer& layer, const Box& box, const Rgba& top, const Rgba& bottom);
void addRectangle(DrawLayer& layer, const Box& box, const Rgba& colour);
/// Adds a rectangle whose colour changes from left to right.
void addRectangleAcross(DrawLayer& layer, const Box& box, const Rgba& left, const Rgba& right);
void addQuad(DrawLayer& layer, const DrawVertex& a, const DrawVertex& b, const DrawVertex& c,
             const DrawVertex& d);
void addLine(DrawLayer& layer, std::vector<DrawPoint> points, float width, const Rgba& colour);
void addOutline(DrawLayer& layer, const Box& box, float width, const Rgba& colour);
/// Adds a box with half-round ends.
void addPill(DrawLayer& layer, const Box& box, const Rgba& colour);
/// Adds a shaft with an open head at `to`; the head's sides are `head` pixels long.
void addArrow(DrawLayer& layer, DrawPoint from, DrawPoint to, float head, float width,
              const Rgba& colour);

// ---- Polylines

/// Returns the parts inside the box, in order; a point that is not finite interrupts the line. A
/// polyline of one point is kept if it lies in the box.
std::vector<Polyline> clippedTo(const Box& box, const Polyline& line);

/// Returns pieces of length `on` with gaps of length `off` along the line, beginning with a piece;
/// corners are kept. `on` = 0 gives single points at distances `off`.
std::vector<Polyline> dashed(const Polyline& line, float on, float off);

// ---- Texts

/// Adds one text; `at` is its anchor on the baseline. An empty one is left out.
void addLabel(DrawList& list, std::string utf8, DrawPoint at, float size, TextAnchor anchor,
              const Rgba& colour, float angle = 0);

/// A piece of a text; a lowered piece is smaller, as in "F_N".
struct TextRun {
  std::string utf8;
  bool bold = false;
  bool lowered = false;
};
using TextRuns = std::vector<TextRun>;

/// Returns the runs with their lowered signs as pieces: the capital N in the subscript of a normal
/// force "F\u2099", and the sign of the modulus "G\u221E". Unicode has neither.
TextRuns withLoweredSigns(const TextRuns& runs);

float textWidth(const TextRuns& runs, float size);
/// Adds text left-aligned on the baseline; returns its right end.
float addText(DrawList& list, const TextRuns& runs, DrawPoint baseline, float size,
              const Rgba& colour);

/// Returns the words without their style: "F\u2099".
std::string plainText(const TextRuns& runs);

// ---- Pictures

/// Adds all of `part`, with its background, to `list`, shifted right and down.
void addPicture(DrawList& list, DrawList part, float right, float down);

/// Returns one picture above the other; as wide as the wider one.
DrawList stacked(DrawList above, DrawList below);

// ---- For the rasterizer, OpenGL and vector files

inline constexpr int kTriangleFloats = 6;  // x y r g b a for each corner
inline constexpr int kSegmentFloats = 17;  // ends (4), neighbours (4), two colours (8), width

/// A box of whole pixels, with OpenGL's origin at the bottom left.
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

/// Returns the mean colour of vertices, channel by channel.
Rgba meanColour(std::span<const DrawVertex> vertices);

/// Fills `clean`, reusing its memory, with the vertices of a line that are finite and do not repeat
/// the previous one; repeated ones would hide the joins.
void cleanVertices(const DrawLine& line, std::vector<DrawVertex>& clean);

/// Fills `geometry`, reusing its memory.
void flatten(const DrawList& list, Geometry& geometry);

}  // namespace asperity
