// The elements of vector files (SVG, PDF): paths of shapes, gradients and fills, and fields as
// images. Pure; any thread.
#pragma once

#include <QImage>
#include <vector>

#include "ui/draw/draw_list.h"
#include "ui/draw/shapes.h"

namespace asperity {

/// A fill of one colour, or a linear gradient from `from` at `start` to `to` at `end`.
struct VectorPaint {
  Rgba from, to;
  DrawPoint start, end;
  bool isGradient = false;
};

/// Closed outlines that are filled together by the non-zero rule.
struct VectorFill {
  VectorPaint paint;
  std::vector<Polyline> outlines;
  /// True for one of many adjacent pieces: antialiased edges between them would show the
  /// background.
  bool isPieceOfMesh = false;
};

/// Polylines drawn by one pen; one of a single point is a round dot.
struct VectorStroke {
  Rgba colour;
  float width = 1;
  std::vector<Polyline> lines;
};

struct VectorLayer {
  Box clip;
  std::vector<VectorFill> fills;      // first is lowest
  std::vector<VectorStroke> strokes;  // over the fills
};

/// Merges consecutive triangles with the same paint into one fill, without the edges between them,
/// and consecutive lines with the same opaque pen into one stroke. A line is split where its colour
/// changes, or has the mean of its colours where it is translucent.
VectorLayer vectorized(const DrawLayer& layer);

/// Returns the outline of triangles of the same orientation: edges that two of them share are left
/// out. Winding numbers do not change.
std::vector<Polyline> triangleOutlines(const std::vector<DrawPoint>& corners);

std::vector<VectorFill> vectorFills(const std::vector<DrawVertex>& triangles);

/// Returns whether the colours agree in eight bits per channel.
bool sameColour(const Rgba& a, const Rgba& b);

/// Returns the box around a field.
Box boundingBox(const DrawField& field);

/// Returns a field as an image over its box, with at most `maxPixels` pixels in each direction.
QImage fieldImage(const DrawField& field, int maxPixels);

}  // namespace asperity
