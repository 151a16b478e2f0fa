#include "ui/draw/vector_shapes.h"

#include <algorithm>
#include <cmath>

#include "ui/draw/colours.h"
#include "ui/draw/vector_fills.h"

namespace asperity {
namespace {

constexpr float kColourSteps = 32;  // of a line whose colour changes, over the whole range
constexpr std::size_t kMostSteps = 16;

bool samePlace(const DrawVertex& a, const DrawVertex& b) {
  return a.x == b.x && a.y == b.y;
}

/// Without what cannot be drawn, and without vertices that repeat the one before.
std::vector<DrawVertex> cleaned(const DrawLine& line) {
  std::vector<DrawVertex> clean;
  for (const DrawVertex& v : line.vertices)
    if (isDrawable(v) && (clean.empty() || !samePlace(clean.back(), v))) clean.push_back(v);
  return clean;
}

bool isTranslucent(const std::vector<DrawVertex>& vertices) {
  return std::any_of(vertices.begin(), vertices.end(),
                     [](const DrawVertex& v) { return v.colour.a < 1; });
}

/// Pieces of a translucent line would show where their ends overlap.
void giveMeanColour(std::vector<DrawVertex>& vertices) {
  Rgba mean{0, 0, 0, 0};
  for (const DrawVertex& v : vertices) {
    mean.r += v.colour.r;
    mean.g += v.colour.g;
    mean.b += v.colour.b;
    mean.a += v.colour.a;
  }
  const auto count = static_cast<float>(vertices.size());
  mean = {mean.r / count, mean.g / count, mean.b / count, mean.a / count};
  for (DrawVertex& v : vertices) v.colour = mean;
}

class StrokeCollector {
 public:
  explicit StrokeCollector(std::vector<VectorStroke>& strokes) : strokes_(strokes) {}

  void add(const DrawLine& line) {
    std::vector<DrawVertex> vertices = cleaned(line);
    if (vertices.empty() || !(line.width > 0)) return;
    width_ = line.width;
    if (isTranslucent(vertices)) giveMeanColour(vertices);
    open_ = false;
    if (vertices.size() == 1) begin(vertices[0].colour, {vertices[0].x, vertices[0].y});
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) addSegment(vertices[i], vertices[i + 1]);
  }

 private:
  /// In steps of nearly one colour.
  void addSegment(const DrawVertex& a, const DrawVertex& b) {
    const float change = kColourSteps * std::max({std::abs(a.colour.r - b.colour.r),
                                                  std::abs(a.colour.g - b.colour.g),
                                                  std::abs(a.colour.b - b.colour.b)});
    const auto steps = std::min(kMostSteps, static_cast<std::size_t>(change) + 1);
    for (std::size_t k = 0; k < steps; ++k) {
      const auto at = [&](float stepsDone) {
        const float t = stepsDone / static_cast<float>(steps);
        return DrawVertex{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, mix(a.colour, b.colour, t)};
      };
      const auto done = static_cast<float>(k);
      const DrawVertex from = at(done), to = k + 1 == steps ? b : at(done + 1);
      const Rgba colour = at(done + 0.5F).colour;
      if (!open_ || !sameColour(strokes_.back().colour, colour)) begin(colour, {from.x, from.y});
      strokes_.back().lines.back().push_back({to.x, to.y});
    }
  }

  /// A new polyline, with the last pen where that cannot be seen.
  void begin(const Rgba& colour, const Place& at) {
    const bool samePen = !strokes_.empty() && strokes_.back().width == width_ &&
                         sameColour(strokes_.back().colour, colour) && colour.a >= 1;
    if (!samePen) strokes_.push_back({colour, width_, {}});
    strokes_.back().lines.push_back({at});
    open_ = true;
  }

  std::vector<VectorStroke>& strokes_;
  float width_ = 1;
  bool open_ = false;  // whether the present line has begun
};

}  // namespace

VectorLayer vectorized(const DrawLayer& layer) {
  VectorLayer vector;
  vector.clip = layer.clip;
  vector.fills = fillsOf(layer.triangles);
  StrokeCollector strokes(vector.strokes);
  for (const DrawLine& line : layer.lines) strokes.add(line);
  return vector;
}

}  // namespace asperity
