#include "ui/draw/geometry.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

bool isFinite(const DrawVertex& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}

void append(std::vector<float>& data, const Rgba& c) {
  data.insert(data.end(), {c.r, c.g, c.b, c.a});
}

/// The pixels whose centres lie in [from, to).
void pixelRange(float from, float to, int size, int& first, int& count) {
  const auto edge = [&](float e) {
    return static_cast<int>(std::clamp(std::ceil(e - 0.5F), 0.0F, static_cast<float>(size)));
  };
  first = edge(from);
  count = std::max(0, edge(to) - first);
}

ScissorBox scissorBox(const Clip& clip, const DrawList& list) {
  if (clip.width == 0) return {0, 0, list.width, list.height};
  ScissorBox box;
  int top = 0;
  pixelRange(clip.x, clip.x + clip.width, list.width, box.x, box.width);
  pixelRange(clip.y, clip.y + clip.height, list.height, top, box.height);
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

bool samePlace(const DrawVertex& a, const DrawVertex& b) {
  return a.x == b.x && a.y == b.y;
}

/// Without vertices that repeat the one before (they would hide the joins) or are not finite.
void cleanVertices(const DrawLine& line, std::vector<DrawVertex>& clean) {
  clean.clear();
  for (const DrawVertex& v : line.vertices)
    if (isFinite(v) && (clean.empty() || !samePlace(clean.back(), v))) clean.push_back(v);
}

void appendSegment(const DrawVertex& before, const DrawVertex& from, const DrawVertex& to,
                   const DrawVertex& after, float width, std::vector<float>& data) {
  data.insert(data.end(), {from.x, from.y, to.x, to.y, before.x, before.y, after.x, after.y});
  append(data, from.colour);
  append(data, to.colour);
  data.push_back(width);
}

/// A line of one vertex is a round dot.
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

void flatten(const DrawList& list, Geometry& geometry) {
  geometry.data.clear();
  geometry.batches.clear();
  std::vector<DrawVertex> clean;
  for (const DrawLayer& layer : list.layers) {
    DrawBatch batch;
    batch.scissor = scissorBox(layer.clip, list);
    appendTriangles(layer.triangles, geometry, batch);
    batch.segmentOffset = geometry.data.size();
    for (const DrawLine& line : layer.lines) {
      cleanVertices(line, clean);
      appendLine(clean, line.width, geometry, batch);
    }
    geometry.batches.push_back(batch);
  }
}

}  // namespace asperity
