// The content of a picture in pixels: filled triangles, antialiased lines and texts, in this order.
// ui/contact and ui/chart make it; ui/draw/renderer.h draws its shapes and ui/draw/fonts.h its
// texts. A plain value; any thread; uses neither OpenGL nor Qt. Coordinates: pixels, origin top
// left, y down. Colours: sRGB, straight alpha.
#pragma once

#include <string>
#include <vector>

namespace asperity {

struct Rgba {
  float r = 0, g = 0, b = 0, a = 1;
};

struct DrawVertex {
  float x = 0, y = 0;
  Rgba colour;
};

/// A polyline of constant width with a colour for each vertex; round joins.
struct DrawLine {
  std::vector<DrawVertex> vertices;
  float width = 1;
};

enum class TextAnchor { Left, Centre, Right };

struct DrawText {
  std::string utf8;
  float x = 0, y = 0;  // anchor point, baseline
  float size = 12;     // pixel height of the font
  TextAnchor anchor = TextAnchor::Left;
  float angle = 0;  // radians, counter-clockwise on the screen
  bool bold = false;
  Rgba colour;
};

/// A rectangle, in pixels.
struct Box {
  float x = 0, y = 0, width = 0, height = 0;
  float right() const { return x + width; }
  float bottom() const { return y + height; }
  bool contains(float px, float py) const {
    return px >= x && px < right() && py >= y && py < bottom();
  }
  bool overlaps(const Box& other) const {
    return x < other.right() && other.x < right() && y < other.bottom() && other.y < bottom();
  }
};

/// Colours on a rectangular grid of points, interpolated between neighbours. In a cell of the grid
/// with a corner without colour (a = 0) nothing is drawn.
struct DrawField {
  std::vector<float> x, y;    // pixels, of columns and rows; rising or falling
  std::vector<Rgba> colours;  // x fastest
};

struct DrawLayer {
  Box clip;                           // nothing is drawn outside of it; width 0: the whole picture
  std::vector<DrawField> fields{};    // under the triangles; vector files have them as images
  std::vector<DrawVertex> triangles;  // three vertices each
  std::vector<DrawLine> lines;        // over the triangles
};

struct DrawList {
  int width = 0, height = 0;  // pixels
  Rgba background;
  std::vector<DrawLayer> layers;  // first is lowest
  std::vector<DrawText> texts;    // over everything
};

}  // namespace asperity
