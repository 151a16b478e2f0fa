#include "ui/draw/vector_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "ui/draw/theme.h"

namespace asperity {
namespace {

constexpr float kColourSteps = 32;  // steps of a line whose colour changes over the whole range
constexpr std::size_t kMaxSteps = 16;

bool isTranslucent(const std::vector<DrawVertex>& vertices) {
  return std::any_of(vertices.begin(), vertices.end(),
                     [](const DrawVertex& v) { return v.colour.a < 1; });
}

class StrokeCollector {
 public:
  explicit StrokeCollector(std::vector<VectorStroke>& strokes) : strokes_(strokes) {}

  void add(const DrawLine& line) {
    std::vector<DrawVertex> vertices;
    cleanVertices(line, vertices);
    if (vertices.empty() || !(line.width > 0)) return;
    width_ = line.width;
    // A translucent line has one colour, because overlapping ends of pieces would be visible.
    if (isTranslucent(vertices))
      for (const Rgba mean = meanColour(vertices); DrawVertex & v : vertices) v.colour = mean;
    open_ = false;
    if (vertices.size() == 1) begin(vertices[0].colour, {vertices[0].x, vertices[0].y});
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) addSegment(vertices[i], vertices[i + 1]);
  }

 private:
  /// Adds a segment in steps of nearly one colour.
  void addSegment(const DrawVertex& a, const DrawVertex& b) {
    const float change = kColourSteps * std::max({std::abs(a.colour.r - b.colour.r),
                                                  std::abs(a.colour.g - b.colour.g),
                                                  std::abs(a.colour.b - b.colour.b)});
    const auto steps = std::min(kMaxSteps, static_cast<std::size_t>(change) + 1);
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

  /// Begins a new polyline, with the last pen where the difference is invisible.
  void begin(const Rgba& colour, const DrawPoint& at) {
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
  vector.fills = vectorFills(layer.triangles);
  StrokeCollector strokes(vector.strokes);
  for (const DrawLine& line : layer.lines) strokes.add(line);
  return vector;
}

namespace {

using Corner = std::array<float, 2>;
using Triangle = std::array<DrawVertex, 3>;

// Differences of visible colour, 0 to 1.
constexpr float kOneColour = 1e-4F;   // a triangle that varies less is treated as one colour
constexpr float kSameShade = 0.012F;  // two descriptions of the same gradient
constexpr float kPiece = 0.08F;       // largest variation in a piece of a mesh
constexpr float kInvisible = 0.002F;  // opacity
constexpr float kSmallest = 4;        // pixels; smaller pieces are not split

float signedArea(const Triangle& t) {
  return ((t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y)) / 2;
}

/// Returns the difference of two colours; a nearly transparent one may have any colour.
float colourDistance(const Rgba& a, const Rgba& b) {
  const float opacity = std::max(a.a, b.a);
  return std::max({opacity * std::abs(a.r - b.r), opacity * std::abs(a.g - b.g),
                   opacity * std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

float variation(const Triangle& t) {
  return std::max({colourDistance(t[0].colour, t[1].colour),
                   colourDistance(t[1].colour, t[2].colour),
                   colourDistance(t[2].colour, t[0].colour)});
}

std::array<float, 4> channels(const Rgba& c) {
  return {c.r, c.g, c.b, c.a};
}

/// The colour as a function of the distance in one direction.
struct Shade {
  DrawPoint origin;
  Rgba colour;                   // at the origin
  float x = 1, y = 0;            // unit vector
  std::array<float, 4> slope{};  // of the channels, per pixel

  float along(const DrawVertex& v) const { return (v.x - origin.x) * x + (v.y - origin.y) * y; }
  Rgba at(float distance) const {
    const auto held = [&](float c, int channel) {
      return std::clamp(c + slope[static_cast<std::size_t>(channel)] * distance, 0.0F, 1.0F);
    };
    return {held(colour.r, 0), held(colour.g, 1), held(colour.b, 2), held(colour.a, 3)};
  }
  bool describes(const Triangle& t) const {
    return std::all_of(t.begin(), t.end(), [&](const DrawVertex& v) {
      return colourDistance(at(along(v)), v.colour) <= kSameShade;
    });
  }
};

/// Returns the shade; none where the colours do not change along one direction.
std::optional<Shade> findShade(const Triangle& t) {
  const double ux = t[1].x - t[0].x, uy = t[1].y - t[0].y;
  const double vx = t[2].x - t[0].x, vy = t[2].y - t[0].y;
  const double determinant = ux * vy - vx * uy;
  const auto c0 = channels(t[0].colour), c1 = channels(t[1].colour), c2 = channels(t[2].colour);
  std::array<std::array<double, 2>, 4> gradients{};
  double steepest = 0;
  Shade shade{{t[0].x, t[0].y}, t[0].colour, 1, 0, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    const double du = c1[i] - c0[i], dv = c2[i] - c0[i];
    gradients[i] = {(du * vy - dv * uy) / determinant, (dv * ux - du * vx) / determinant};
    const double size = std::hypot(gradients[i][0], gradients[i][1]);
    if (size <= steepest) continue;
    steepest = size;
    shade.x = static_cast<float>(gradients[i][0] / size);
    shade.y = static_cast<float>(gradients[i][1] / size);
  }
  for (std::size_t i = 0; i < 4; ++i)
    shade.slope[i] = static_cast<float>(gradients[i][0] * shade.x + gradients[i][1] * shade.y);
  if (!std::isfinite(shade.x + shade.y) || !shade.describes(t)) return std::nullopt;
  return shade;
}

/// Collects triangles until one needs another paint.
class FillCollector {
 public:
  void add(Triangle t) {
    const float area = signedArea(t);
    if (!(std::abs(area) > 1e-6F)) return;
    if (std::max({t[0].colour.a, t[1].colour.a, t[2].colour.a}) < kInvisible) return;
    if (area < 0) std::swap(t[1], t[2]);
    if (variation(t) <= kOneColour)
      addFlat(t, meanColour(t), false);
    else if (shade_ && shade_->describes(t))
      append(t);
    else if (const auto shade = findShade(t))
      start(*shade, t);
    else
      addPieces(t);
  }

  std::vector<VectorFill> take() {
    finish();
    return std::move(fills_);
  }

 private:
  void addFlat(const Triangle& t, const Rgba& colour, bool piece) {
    if (!flat_ || !sameColour(*flat_, colour) || piece_ != piece) {
      finish();
      flat_ = colour;
      piece_ = piece;
    }
    append(t);
  }

  void start(const Shade& shade, const Triangle& t) {
    finish();
    shade_ = shade;
    least_ = most_ = 0;
    append(t);
  }

  void append(const Triangle& t) {
    for (const DrawVertex& v : t) {
      corners_.push_back({v.x, v.y});
      if (!shade_) continue;
      least_ = std::min(least_, shade_->along(v));
      most_ = std::max(most_, shade_->along(v));
    }
  }

  /// Splits a triangle into four at the middles of its sides, until each is nearly of one colour.
  void addPieces(const Triangle& t) {
    float longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, std::hypot(t[i].x - t[(i + 1) % 3].x, t[i].y - t[(i + 1) % 3].y));
    if (variation(t) <= kPiece || longest <= kSmallest) return addFlat(t, meanColour(t), true);
    const auto middle = [&](std::size_t a, std::size_t b) {
      return DrawVertex{(t[a].x + t[b].x) / 2, (t[a].y + t[b].y) / 2,
                        mix(t[a].colour, t[b].colour, 0.5F)};
    };
    const DrawVertex ab = middle(0, 1), bc = middle(1, 2), ca = middle(2, 0);
    for (const Triangle& piece : {Triangle{t[0], ab, ca}, Triangle{ab, t[1], bc},
                                  Triangle{ca, bc, t[2]}, Triangle{ab, bc, ca}})
      addPieces(piece);
  }

  void finish() {
    if (!corners_.empty()) {
      VectorFill fill;
      fill.outlines = triangleOutlines(corners_);
      if (shade_) {
        const auto at = [&](float distance) {
          return DrawPoint{shade_->origin.x + distance * shade_->x,
                           shade_->origin.y + distance * shade_->y};
        };
        fill.paint = {shade_->at(least_), shade_->at(most_), at(least_), at(most_), true};
      } else {
        fill.paint.from = fill.paint.to = *flat_;
      }
      fill.isPieceOfMesh = shade_.has_value() || piece_;
      fills_.push_back(std::move(fill));
    }
    corners_.clear();
    shade_.reset();
    flat_.reset();
    piece_ = false;
  }

  std::vector<VectorFill> fills_;
  std::vector<DrawPoint> corners_;
  std::optional<Shade> shade_;
  std::optional<Rgba> flat_;
  bool piece_ = false;
  float least_ = 0, most_ = 0;
};

}  // namespace

std::vector<VectorFill> vectorFills(const std::vector<DrawVertex>& triangles) {
  FillCollector fills;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
    if (isFinite(triangles[i]) && isFinite(triangles[i + 1]) && isFinite(triangles[i + 2]))
      fills.add({triangles[i], triangles[i + 1], triangles[i + 2]});
  return fills.take();
}

std::vector<Polyline> triangleOutlines(const std::vector<DrawPoint>& corners) {
  std::map<std::pair<Corner, Corner>, int> edges;  // count of an edge minus that of its reverse
  std::vector<std::pair<Corner, Corner>> order;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const DrawPoint &p = corners[i + k], &q = corners[i + (k + 1) % 3];
      const Corner a{p.x, p.y}, b{q.x, q.y};
      if (const auto reverse = edges.find({b, a}); reverse != edges.end() && reverse->second > 0) {
        --reverse->second;
      } else {
        ++edges[{a, b}];
        order.emplace_back(a, b);
      }
    }
  std::map<Corner, std::vector<Corner>> next;
  for (auto edge = order.rbegin(); edge != order.rend(); ++edge)
    if (int& left = edges[*edge]; left > 0) {
      --left;
      next[edge->first].push_back(edge->second);
    }
  std::vector<Polyline> outlines;
  for (const auto& [start, unused] : order) {
    if (next[start].empty()) continue;
    Polyline outline;
    for (Corner at = start; !next[at].empty();) {
      outline.push_back({at[0], at[1]});
      const Corner to = next[at].back();
      next[at].pop_back();
      at = to;
    }
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

bool sameColour(const Rgba& a, const Rgba& b) {
  const auto one = channels(a), other = channels(b);
  return std::equal(one.begin(), one.end(), other.begin(),
                    [](float x, float y) { return std::lround(255 * x) == std::lround(255 * y); });
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

/// Returns the colours of a field at the centres of a raster over its box, row by row from the top;
/// a = 0 where there is none.
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

}  // namespace

QImage fieldImage(const DrawField& field, int maxPixels) {
  const Box box = boundingBox(field);
  const auto pixels = [maxPixels](float size) {
    return std::clamp(static_cast<int>(std::ceil(size)), 1, maxPixels);
  };
  const int columns = pixels(box.width), rows = pixels(box.height);
  const std::vector<Rgba> raster = sampledColours(field, columns, rows);
  if (raster.empty()) return {};
  QImage image(columns, rows, QImage::Format_ARGB32);
  bool isOpaque = true;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const Rgba& colour = raster[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                                  static_cast<std::size_t>(i)];
      isOpaque = isOpaque && colour.a >= 1;
      const auto byte = [](float part) { return static_cast<int>(std::lround(255 * part)); };
      image.setPixel(i, j, qRgba(byte(colour.r), byte(colour.g), byte(colour.b), byte(colour.a)));
    }
  return isOpaque ? image.convertToFormat(QImage::Format_RGB888) : image;
}

}  // namespace asperity
