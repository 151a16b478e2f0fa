#include "ui/draw/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "ui/draw/fonts.h"

namespace asperity {
namespace {

void append(std::vector<float>& data, const Rgba& c) {
  data.insert(data.end(), {c.r, c.g, c.b, c.a});
}

/// Returns the pixels whose centres lie in [from, to).
void pixelRange(float from, float to, int size, int& first, int& count) {
  const auto edge = [&](float e) {
    return static_cast<int>(std::clamp(std::ceil(e - 0.5F), 0.0F, static_cast<float>(size)));
  };
  first = edge(from);
  count = std::max(0, edge(to) - first);
}

ScissorBox scissorBox(const Box& clip, const DrawList& list) {
  if (clip.width == 0) return {0, 0, list.width, list.height};
  ScissorBox box;
  int top = 0;
  pixelRange(clip.x, clip.right(), list.width, box.x, box.width);
  pixelRange(clip.y, clip.bottom(), list.height, top, box.height);
  box.y = list.height - top - box.height;
  return box;
}

void appendTriangles(const std::vector<DrawVertex>& corners, Geometry& geometry, DrawBatch& batch) {
  batch.triangleOffset = geometry.data.size();
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    if (!isFinite(corners[i]) || !isFinite(corners[i + 1]) || !isFinite(corners[i + 2])) continue;
    for (std::size_t k = i; k < i + 3; ++k) {
      geometry.data.push_back(corners[k].x);
      geometry.data.push_back(corners[k].y);
      append(geometry.data, corners[k].colour);
    }
    batch.triangleCorners += 3;
  }
}

/// Returns a field as triangles, four around the middle of each cell of its grid.
std::vector<DrawVertex> fieldTriangles(const DrawField& field) {
  const std::size_t columns = field.x.size();
  std::vector<DrawVertex> corners;
  for (std::size_t j = 0; j + 1 < field.y.size(); ++j)
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const auto vertex = [&](std::size_t column, std::size_t row) {
        return DrawVertex{field.x[column], field.y[row], field.colours[row * columns + column]};
      };
      const DrawVertex around[] = {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1),
                                   vertex(i, j + 1)};
      if (std::ranges::any_of(around, [](const DrawVertex& v) { return v.colour.a == 0; }))
        continue;
      const DrawVertex middle{(around[0].x + around[2].x) / 2, (around[0].y + around[2].y) / 2,
                              meanColour(around)};
      for (std::size_t k = 0; k < 4; ++k)
        corners.insert(corners.end(), {around[k], around[(k + 1) % 4], middle});
    }
  return corners;
}

void appendSegment(const DrawVertex& before, const DrawVertex& from, const DrawVertex& to,
                   const DrawVertex& after, float width, std::vector<float>& data) {
  data.insert(data.end(), {from.x, from.y, to.x, to.y, before.x, before.y, after.x, after.y});
  append(data, from.colour);
  append(data, to.colour);
  data.push_back(width);
}

/// Appends a line; a line of one vertex is a round dot.
void appendLine(const std::vector<DrawVertex>& v, float width, Geometry& geometry,
                DrawBatch& batch) {
  if (v.empty() || !(width > 0)) return;
  const std::size_t last = v.size() - 1;
  const std::size_t segments = std::max<std::size_t>(last, 1);
  for (std::size_t i = 0; i < segments; ++i) {
    const std::size_t next = std::min(i + 1, last);
    appendSegment(v[i == 0 ? 0 : i - 1], v[i], v[next], v[std::min(i + 2, last)], width,
                  geometry.data);
  }
  batch.segments += segments;
}

}  // namespace

Rgba meanColour(std::span<const DrawVertex> vertices) {
  Rgba sum{0, 0, 0, 0};
  for (const DrawVertex& v : vertices) {
    sum.r += v.colour.r;
    sum.g += v.colour.g;
    sum.b += v.colour.b;
    sum.a += v.colour.a;
  }
  const auto count = static_cast<float>(vertices.size());
  return {sum.r / count, sum.g / count, sum.b / count, sum.a / count};
}

void cleanVertices(const DrawLine& line, std::vector<DrawVertex>& clean) {
  clean.clear();
  for (const DrawVertex& v : line.vertices)
    if (isFinite(v) && (clean.empty() || !isSamePoint(clean.back(), v))) clean.push_back(v);
}

void flatten(const DrawList& list, Geometry& geometry) {
  geometry.data.clear();
  geometry.batches.clear();
  std::vector<DrawVertex> clean;
  for (const DrawLayer& layer : list.layers) {
    DrawBatch batch;
    batch.scissor = scissorBox(layer.clip, list);
    if (layer.fields.empty()) {
      appendTriangles(layer.triangles, geometry, batch);
    } else {
      std::vector<DrawVertex> corners;
      for (const DrawField& field : layer.fields)
        for (const DrawVertex& corner : fieldTriangles(field)) corners.push_back(corner);
      corners.insert(corners.end(), layer.triangles.begin(), layer.triangles.end());
      appendTriangles(corners, geometry, batch);
    }
    batch.segmentOffset = geometry.data.size();
    for (const DrawLine& line : layer.lines) {
      cleanVertices(line, clean);
      appendLine(clean, line.width, geometry, batch);
    }
    geometry.batches.push_back(batch);
  }
}

namespace {

/// Returns the size of a piece. A lowered piece is smaller; the sign of infinity, which is low
/// anyway, would be unreadable then.
float sizeOf(const TextRun& run, float size) {
  if (!run.lowered || run.utf8 == "\u221E") return size;
  return std::max(6.0F, std::round(size * 0.72F));
}

/// Returns the space on either side of a lowered piece.
float italicOverhang(const TextRun& run, float size) {
  return run.lowered ? 0.06F * size : 0;
}

float runWidth(const TextRun& run, float size) {
  const float text = textWidth(run.utf8, sizeOf(run, size), run.bold);
  return text + 2 * italicOverhang(run, size);
}

}  // namespace

TextRuns withLoweredSigns(const TextRuns& runs) {
  struct Sign {
    std::string_view written, before, lowered;
  };
  constexpr std::array<Sign, 2> signs{{{"\u2099", "", "N"}, {"G\u221E", "G", "\u221E"}}};
  TextRuns split;
  const auto add = [&split](const TextRun& run, std::string_view text, bool lowered) {
    if (!text.empty()) split.push_back({std::string(text), run.bold, lowered});
  };
  for (const TextRun& run : runs) {
    std::string_view rest = run.utf8;
    while (!rest.empty()) {
      const Sign& sign = *std::ranges::min_element(
          signs, {}, [&](const Sign& one) { return rest.find(one.written); });
      const std::size_t at = rest.find(sign.written);
      if (at == rest.npos) break;
      add(run, rest.substr(0, at + sign.before.size()), run.lowered);
      add(run, sign.lowered, true);
      rest.remove_prefix(at + sign.written.size());
    }
    add(run, rest, run.lowered);
  }
  return split;
}

void addQuad(DrawLayer& layer, const DrawVertex& a, const DrawVertex& b, const DrawVertex& c,
             const DrawVertex& d) {
  layer.triangles.insert(layer.triangles.end(), {a, b, c, a, c, d});
}

void addRectangle(DrawLayer& layer, const Box& box, const Rgba& top, const Rgba& bottom) {
  addQuad(layer, {box.x, box.y, top}, {box.right(), box.y, top},
          {box.right(), box.bottom(), bottom}, {box.x, box.bottom(), bottom});
}

void addRectangle(DrawLayer& layer, const Box& box, const Rgba& colour) {
  addRectangle(layer, box, colour, colour);
}

void addRectangleAcross(DrawLayer& layer, const Box& box, const Rgba& left, const Rgba& right) {
  addQuad(layer, {box.x, box.y, left}, {box.right(), box.y, right},
          {box.right(), box.bottom(), right}, {box.x, box.bottom(), left});
}

void addLine(DrawLayer& layer, std::vector<DrawPoint> points, float width, const Rgba& colour) {
  DrawLine line;
  line.width = width;
  for (const DrawPoint& p : points) line.vertices.push_back({p.x, p.y, colour});
  layer.lines.push_back(std::move(line));
}

void addOutline(DrawLayer& layer, const Box& box, float width, const Rgba& colour) {
  addLine(layer,
          {{box.x, box.y},
           {box.right(), box.y},
           {box.right(), box.bottom()},
           {box.x, box.bottom()},
           {box.x, box.y}},
          width, colour);
}

void addPill(DrawLayer& layer, const Box& box, const Rgba& colour) {
  const float radius = std::min(box.height, box.width) / 2;
  const float y = box.y + box.height / 2;
  addLine(layer, {{box.x + radius, y}, {box.right() - radius, y}}, box.height, colour);
}

void addArrow(DrawLayer& layer, DrawPoint from, DrawPoint to, float head, float width,
              const Rgba& colour) {
  const float angle = std::atan2(to.y - from.y, to.x - from.x);
  const auto side = [&](float turn) {
    return DrawPoint{to.x - head * std::cos(angle + turn), to.y - head * std::sin(angle + turn)};
  };
  addLine(layer, {from, to}, width, colour);
  addLine(layer, {side(0.6F), to, side(-0.6F)}, width, colour);
}

void addLabel(DrawList& list, std::string utf8, DrawPoint at, float size, TextAnchor anchor,
              const Rgba& colour, float angle) {
  if (utf8.empty()) return;
  const TextRuns runs = withLoweredSigns({{utf8}});
  if (runs.size() > 1) {
    const float width = textWidth(runs, size);
    const float before = anchor == TextAnchor::Left     ? 0
                         : anchor == TextAnchor::Centre ? width / 2
                                                        : width;
    const std::size_t first = list.texts.size();
    addText(list, runs, {at.x - before, at.y}, size, colour);
    if (angle == 0) return;
    // The pieces turn about the anchor, counterclockwise.
    for (std::size_t i = first; i < list.texts.size(); ++i) {
      DrawText& piece = list.texts[i];
      const float along = piece.x - at.x, down = piece.y - at.y;
      piece.x = at.x + along * std::cos(angle) + down * std::sin(angle);
      piece.y = at.y - along * std::sin(angle) + down * std::cos(angle);
      piece.angle = angle;
    }
    return;
  }
  DrawText text;
  text.utf8 = std::move(utf8);
  text.x = at.x;
  text.y = at.y;
  text.size = size;
  text.anchor = anchor;
  text.angle = angle;
  text.colour = colour;
  list.texts.push_back(std::move(text));
}

float textWidth(const TextRuns& runs, float size) {
  float width = 0;
  for (const TextRun& run : runs) width += runWidth(run, size);
  return width;
}

float addText(DrawList& list, const TextRuns& runs, DrawPoint baseline, float size,
              const Rgba& colour) {
  for (const TextRun& run : withLoweredSigns(runs)) {
    DrawText text;
    text.utf8 = run.utf8;
    text.x = baseline.x + italicOverhang(run, size);
    text.y = run.lowered ? baseline.y + std::round(size * 0.22F) : baseline.y;
    text.size = sizeOf(run, size);
    text.bold = run.bold;
    text.colour = colour;
    baseline.x += runWidth(run, size);
    list.texts.push_back(std::move(text));
  }
  return baseline.x;
}

std::string plainText(const TextRuns& runs) {
  std::string text;
  for (const TextRun& run : runs) {
    if (run.lowered && run.utf8 == "N")
      text += "\u2099";
    else if (run.lowered && run.utf8 == "x")
      text += "\u2093";
    else
      text += run.utf8;
  }
  return text;
}

void addPicture(DrawList& list, DrawList part, float right, float down) {
  const Box box{right, down, static_cast<float>(part.width), static_cast<float>(part.height)};
  if (part.background.a > 0) {
    DrawLayer background;
    addRectangle(background, box, part.background);
    list.layers.push_back(std::move(background));
  }
  for (DrawLayer& layer : part.layers) {
    if (layer.clip.width > 0)
      layer.clip = {layer.clip.x + right, layer.clip.y + down, layer.clip.width, layer.clip.height};
    else
      layer.clip = box;
    const auto move = [&](std::vector<DrawVertex>& vertices) {
      for (DrawVertex& vertex : vertices) {
        vertex.x += right;
        vertex.y += down;
      }
    };
    for (DrawField& field : layer.fields) {
      for (float& x : field.x) x += right;
      for (float& y : field.y) y += down;
    }
    move(layer.triangles);
    for (DrawLine& line : layer.lines) move(line.vertices);
    list.layers.push_back(std::move(layer));
  }
  for (DrawText& text : part.texts) {
    text.x += right;
    text.y += down;
    list.texts.push_back(std::move(text));
  }
}

DrawList stacked(DrawList above, DrawList below) {
  DrawList list;
  list.width = std::max(above.width, below.width);
  list.height = above.height + below.height;
  list.background = above.background;
  const auto down = static_cast<float>(above.height);
  below.background.a = 0;
  above.background.a = 0;
  addPicture(list, std::move(above), 0, 0);
  addPicture(list, std::move(below), 0, down);
  return list;
}

// ---- Polylines

namespace {

struct Piece {
  DrawPoint from, to;
};

DrawPoint between(const DrawPoint& a, const DrawPoint& b, double t) {
  return {static_cast<float>(a.x + t * (static_cast<double>(b.x) - a.x)),
          static_cast<float>(a.y + t * (static_cast<double>(b.y) - a.y))};
}

/// Clips a segment by the method of Liang and Barsky (1984).
std::optional<Piece> inside(const Box& box, const DrawPoint& a, const DrawPoint& b) {
  double first = 0, last = 1;
  const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
  const double steps[4][2] = {{-dx, static_cast<double>(a.x) - box.x},
                              {dx, static_cast<double>(box.right()) - a.x},
                              {-dy, static_cast<double>(a.y) - box.y},
                              {dy, static_cast<double>(box.bottom()) - a.y}};
  for (const auto& [change, distance] : steps) {
    if (change == 0) {
      if (distance < 0) return std::nullopt;
    } else if (change < 0) {
      first = std::max(first, distance / change);
    } else {
      last = std::min(last, distance / change);
    }
  }
  if (first > last) return std::nullopt;
  return Piece{first > 0 ? between(a, b, first) : a, last < 1 ? between(a, b, last) : b};
}

}  // namespace

std::vector<Polyline> clippedTo(const Box& box, const Polyline& line) {
  std::vector<Polyline> parts;
  if (line.size() == 1 && isFinite(line[0]) && inside(box, line[0], line[0])) return {line};
  bool joined = false;  // whether the last part ends where the next segment begins
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (!isFinite(line[i]) || !isFinite(line[i + 1])) {
      joined = false;
      continue;
    }
    const auto piece = inside(box, line[i], line[i + 1]);
    if (!piece) {
      joined = false;
      continue;
    }
    if (!joined || !isSamePoint(parts.back().back(), piece->from)) parts.push_back({piece->from});
    parts.back().push_back(piece->to);
    joined = isSamePoint(piece->to, line[i + 1]);
  }
  return parts;
}

std::vector<Polyline> dashed(const Polyline& line, float on, float off) {
  std::vector<Polyline> pieces;
  if (line.empty() || !(on >= 0) || !(off > 0)) return pieces;
  const double period = static_cast<double>(on) + off;
  pieces.push_back({line[0]});
  bool drawing = on > 0;
  double left = drawing ? on : period;  // rest of the dash or the gap
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = std::hypot(line[i + 1].x - line[i].x, line[i + 1].y - line[i].y);
    double at = 0;
    while (length - at >= left) {
      at += left;
      const DrawPoint here = between(line[i], line[i + 1], at / length);
      if (drawing)
        pieces.back().push_back(here);
      else
        pieces.push_back({here});
      drawing = on > 0 && !drawing;
      left = on == 0 ? period : drawing ? on : off;
    }
    left -= length - at;
    if (drawing && length > at) pieces.back().push_back(line[i + 1]);
  }
  // The line ended at the beginning of a dash.
  if (on > 0 && pieces.size() > 1 && pieces.back().size() == 1) pieces.pop_back();
  return pieces;
}

}  // namespace asperity
