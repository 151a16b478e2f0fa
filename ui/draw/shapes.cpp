#include "ui/draw/shapes.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ui/draw/fonts.h"
#include "ui/draw/theme.h"

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

Rgba meanOf(const Rgba& a, const Rgba& b, const Rgba& c, const Rgba& d) {
  return {(a.r + b.r + c.r + d.r) / 4, (a.g + b.g + c.g + d.g) / 4, (a.b + b.b + c.b + d.b) / 4,
          (a.a + b.a + c.a + d.a) / 4};
}

/// Returns a field as triangles, four around the middle of each cell of its grid.
std::vector<DrawVertex> trianglesOf(const DrawField& field) {
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
      const DrawVertex middle{
          (around[0].x + around[2].x) / 2, (around[0].y + around[2].y) / 2,
          meanOf(around[0].colour, around[1].colour, around[2].colour, around[3].colour)};
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
        for (const DrawVertex& corner : trianglesOf(field)) corners.push_back(corner);
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

float loweredSize(float size) {
  return std::max(6.0F, std::round(size * 0.72F));
}

/// Returns the space on either side of a lowered piece.
float italicOverhang(const TextRun& run, float size) {
  return run.lowered ? 0.06F * size : 0;
}

float runWidth(const TextRun& run, float size) {
  const float text = textWidth(run.utf8, run.lowered ? loweredSize(size) : size, run.bold);
  return text + 2 * italicOverhang(run, size);
}

/// Replaces the small letter in the subscript of a normal force by a lowered capital N, which
/// Unicode does not have.
TextRuns withLoweredN(const TextRuns& runs) {
  constexpr std::string_view kSmall = "\u2099";
  TextRuns split;
  for (const TextRun& run : runs) {
    std::size_t from = 0;
    for (std::size_t at = run.utf8.find(kSmall); at != std::string::npos;
         at = run.utf8.find(kSmall, from)) {
      if (at > from) split.push_back({run.utf8.substr(from, at - from), run.bold, run.lowered});
      split.push_back({"N", run.bold, true});
      from = at + kSmall.size();
    }
    if (from < run.utf8.size()) split.push_back({run.utf8.substr(from), run.bold, run.lowered});
  }
  return split;
}

}  // namespace

void addQuad(DrawLayer& layer, const DrawVertex& a, const DrawVertex& b, const DrawVertex& c,
             const DrawVertex& d) {
  layer.triangles.insert(layer.triangles.end(), {a, b, c, a, c, d});
}

Box boundingBox(const DrawField& field) {
  if (field.x.empty() || field.y.empty()) return {};
  const auto [left, right] = std::ranges::minmax(field.x);
  const auto [top, bottom] = std::ranges::minmax(field.y);
  return {left, top, right - left, bottom - top};
}

namespace {

/// A position between two neighbours of a list.
struct Between {
  std::size_t index = 0;
  float part = 0;
};

/// Returns the position of a value in an ascending or descending list that contains it.
Between betweenIn(const std::vector<float>& list, float value) {
  const bool rises = list.front() <= list.back();
  std::size_t low = 0, high = list.size() - 1;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    ((list[middle] <= value) == rises ? low : high) = middle;
  }
  const float size = list[high] - list[low];
  return {low, size != 0 ? std::clamp((value - list[low]) / size, 0.0F, 1.0F) : 0};
}

}  // namespace

std::vector<Rgba> sampledColours(const DrawField& field, int columns, int rows) {
  std::vector<Rgba> raster;
  if (field.x.size() < 2 || field.y.size() < 2) return raster;
  raster.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  const Box box = boundingBox(field);
  const std::size_t width = field.x.size();
  std::vector<Between> across;
  for (int i = 0; i < columns; ++i)
    across.push_back(betweenIn(
        field.x, box.x + box.width * (static_cast<float>(i) + 0.5F) / static_cast<float>(columns)));
  for (int j = 0; j < rows; ++j) {
    const Between down = betweenIn(
        field.y, box.y + box.height * (static_cast<float>(j) + 0.5F) / static_cast<float>(rows));
    for (const Between& right : across) {
      const Rgba* row = &field.colours[down.index * width + right.index];
      const Rgba* next = row + width;
      const bool isKnown = row[0].a > 0 && row[1].a > 0 && next[0].a > 0 && next[1].a > 0;
      raster.push_back(isKnown ? mix(mix(row[0], row[1], right.part),
                                     mix(next[0], next[1], right.part), down.part)
                               : Rgba{0, 0, 0, 0});
    }
  }
  return raster;
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
  const TextRuns runs = withLoweredN({{utf8}});
  if (runs.size() > 1 && angle == 0) {
    const float width = textWidth(runs, size);
    if (anchor == TextAnchor::Centre) at.x -= width / 2;
    if (anchor == TextAnchor::Right) at.x -= width;
    addText(list, runs, at, size, colour);
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
  for (const TextRun& run : withLoweredN(runs)) {
    DrawText text;
    text.utf8 = run.utf8;
    text.x = baseline.x + italicOverhang(run, size);
    text.y = run.lowered ? baseline.y + std::round(size * 0.22F) : baseline.y;
    text.size = run.lowered ? loweredSize(size) : size;
    text.bold = run.bold;
    text.colour = colour;
    baseline.x += runWidth(run, size);
    list.texts.push_back(std::move(text));
  }
  return baseline.x;
}

}  // namespace asperity
