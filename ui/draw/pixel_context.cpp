// Contexts for pixels, and the program's own rasterizer. Contact pictures are mostly columns of one
// colour, for which it takes a fifth of the time that OpenGL in software needs, and the bytes
// depend on neither the machine's driver nor on its threads. Its pixels follow OpenGL's rules and
// the renderer's shaders (pixel centres, shared edges belong to one triangle, coverage of lines by
// distance), so that both draw the same picture within a level of 255 except on single pixels of
// edges.
#include "ui/draw/pixel_context.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "ui/draw/shapes.h"

namespace asperity {
namespace {

/// Four numbers for the vector unit: the channels of a colour, or neighbouring pixels.
using Four = float __attribute__((vector_size(16)));
using FourInts = std::int32_t __attribute__((vector_size(16)));
using FourBytes = std::uint8_t __attribute__((vector_size(4)));

constexpr int kTogether = 4;  // pixels of a line computed at once

Four least(Four a, Four b) {
  return a < b ? a : b;
}
Four most(Four a, Four b) {
  return a > b ? a : b;
}

/// Returns channels from 0 to 1.
Four channels(const Rgba& c) {
  return Four{c.r, c.g, c.b, c.a};
}

/// A colour over a pixel: channels of 255 levels as the pixel has them, and how much of it.
struct Paint {
  Four levels;
  float weight;
};

Paint toPaint(Four colour) {
  const Four bounded = most(least(colour, Four{1, 1, 1, 1}), Four{0, 0, 0, 0});
  Paint paint{bounded * 255, bounded[3]};
  paint.levels[3] = 255;
  return paint;
}

/// Returns the four bytes of levels.
std::uint32_t toBytes(Four levels) {
  const auto bytes =
      __builtin_convertvector(__builtin_convertvector(levels + 0.5F, FourInts), FourBytes);
  std::uint32_t word = 0;
  std::memcpy(&word, &bytes, sizeof word);
  return word;
}

/// Blends a colour over a pixel of premultiplied colours.
inline void blend(std::uint8_t* pixel, const Paint& paint) {
  FourBytes bytes;
  std::memcpy(&bytes, pixel, sizeof bytes);
  const Four under = __builtin_convertvector(bytes, Four);
  const std::uint32_t word = toBytes(under + (paint.levels - under) * paint.weight);
  std::memcpy(pixel, &word, sizeof word);
}

/// Returns the first pixel whose centre is at or after this position, between `from` >= 0 and `to`.
int pixelAt(double place, int from, int to) {
  const double bounded = std::min(std::max(place - 0.5, double(from)), double(to));
  const int below = static_cast<int>(bounded);
  return below + (below < bounded ? 1 : 0);
}

/// The pixels that may be changed: rows and columns of a picture, from its top left.
struct Canvas {
  std::uint8_t* bytes;
  int width;
  int left, top, right, bottom;  // within the clip

  std::uint8_t* pixel(int x, int y) const {
    return bytes + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x));
  }
};

void fill(std::uint8_t* pixel, int count, std::uint32_t word) {
  for (int i = 0; i < count; ++i) std::memcpy(pixel + 4 * i, &word, sizeof word);
}

// ---- Triangles

struct Corner {
  float x, y;
  Rgba colour;
};

/// An edge from its upper to its lower corner. Two triangles with a common edge compute the same
/// points on it, so that they leave no gap and share no pixel.
struct Edge {
  Edge(const Corner& a, const Corner& b)
      : x(a.x), y(a.y), slope(b.y > a.y ? (double{b.x} - a.x) / (double{b.y} - a.y) : 0) {}
  double at(double row) const { return x + (row - y) * slope; }

  double x, y, slope;
};

/// The colour of a triangle, which is linear in x and y.
class Gradient {
 public:
  Gradient(const Corner& a, const Corner& b, const Corner& c)
      : x_(a.x - 0.5F), y_(a.y - 0.5F), colour_(channels(a.colour)) {
    const Four d1 = channels(b.colour) - colour_, d2 = channels(c.colour) - colour_;
    isOpaque_ = a.colour.a >= 1 && b.colour.a >= 1 && c.colour.a >= 1;
    isFlat_ = isZero(d1) && isZero(d2);
    isSameAcross_ = isFlat_;
    if (isFlat_) return;
    const float dx1 = b.x - a.x, dy1 = b.y - a.y, dx2 = c.x - a.x, dy2 = c.y - a.y;
    const float inverse = 1 / (dx1 * dy2 - dx2 * dy1);
    across_ = (d1 * dy2 - d2 * dy1) * inverse;
    down_ = (d2 * dx1 - d1 * dx2) * inverse;
    isSameAcross_ = isZero(across_);
  }

  bool isSameAcross() const { return isSameAcross_; }
  bool isOpaque() const { return isOpaque_; }

  /// Returns the colour in the middle of a pixel, and its change to the next one in the row.
  Four at(int x, int y) const {
    if (isFlat_) return colour_;
    return colour_ + across_ * (static_cast<float>(x) - x_) + down_ * (static_cast<float>(y) - y_);
  }
  Four across() const { return across_; }

 private:
  static bool isZero(Four v) { return v[0] == 0 && v[1] == 0 && v[2] == 0 && v[3] == 0; }

  float x_, y_;
  Four colour_, across_{}, down_{};
  bool isFlat_, isSameAcross_, isOpaque_;
};

/// Draws the pixels from `left` to `right` of a row.
void drawSpan(const Canvas& canvas, const Gradient& gradient, int left, int right, int y) {
  std::uint8_t* pixel = canvas.pixel(left, y);
  Four colour = gradient.at(left, y);
  if (gradient.isSameAcross()) {
    const Paint paint = toPaint(colour);
    if (gradient.isOpaque()) return fill(pixel, right - left, toBytes(paint.levels));
    for (int x = left; x < right; ++x, pixel += 4) blend(pixel, paint);
    return;
  }
  for (int x = left; x < right; ++x, pixel += 4, colour += gradient.across()) {
    const Paint paint = toPaint(colour);
    if (gradient.isOpaque())
      fill(pixel, 1, toBytes(paint.levels));
    else
      blend(pixel, paint);
  }
}

void drawTriangle(const Canvas& canvas, const float* floats) {
  std::array<Corner, 3> corners;
  for (Corner& corner : corners) {
    corner = {floats[0], floats[1], {floats[2], floats[3], floats[4], floats[5]}};
    floats += kTriangleFloats;
  }
  const Gradient gradient(corners[0], corners[1], corners[2]);
  std::ranges::sort(
      corners, [](const Corner& a, const Corner& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  const auto& [upper, middle, lower] = corners;
  const int first = pixelAt(upper.y, canvas.top, canvas.bottom);
  const int last = pixelAt(lower.y, canvas.top, canvas.bottom);
  const Edge whole(upper, lower), above(upper, middle), below(middle, lower);
  for (int y = first; y < last; ++y) {
    const double row = y + 0.5;
    const double a = whole.at(row), b = row < middle.y ? above.at(row) : below.at(row);
    const int left = pixelAt(std::min(a, b), canvas.left, canvas.right);
    const int right = pixelAt(std::max(a, b), canvas.left, canvas.right);
    if (left < right) drawSpan(canvas, gradient, left, right, y);
  }
}

// ---- Lines

/// A straight piece, ready for its distances from four neighbouring pixels of a row.
struct Piece {
  Piece(const float* a, const float* b) : x(a[0]), y(a[1]), dx(b[0] - a[0]), dy(b[1] - a[1]) {
    const float square = dx * dx + dy * dy;
    inverse = square > 0 ? 1 / square : 0;
  }
  /// Returns the nearest points on the piece, from 0 to 1.
  Four place(Four px, float py) const {
    const Four along = ((px - x) * dx + (py - y) * dy) * inverse;
    return most(least(along, Four{1, 1, 1, 1}), Four{0, 0, 0, 0});
  }
  Four squareTo(Four px, float py, Four along) const {
    const Four right = px - x - along * dx, down = py - y - along * dy;
    return right * right + down * down;
  }
  Four square(Four px, float py) const { return squareTo(px, py, place(px, py)); }

  float x, y, dx, dy, inverse = 0;
};

/// The interval of x in which a quantity linear in x and in the row is within limits.
class Band {
 public:
  /// The linear function acrossX * x + acrossRow * row.
  Band(double acrossX, double acrossRow, double low, double high)
      : isEven_(std::abs(acrossX) < 1e-9), low_(low), high_(high), acrossRow_(acrossRow) {
    if (isEven_) return;
    const double inverse = 1 / acrossX;
    slope_ = -acrossRow * inverse;
    from_ = std::min(low * inverse, high * inverse);
    to_ = std::max(low * inverse, high * inverse);
  }

  /// Reduces the interval [from, to] to its part in the band.
  void limit(double row, double& from, double& to) const {
    if (isEven_) {
      if (acrossRow_ * row < low_ || acrossRow_ * row > high_) to = from - 1;
      return;
    }
    from = std::max(from, from_ + slope_ * row);
    to = std::min(to, to_ + slope_ * row);
  }

 private:
  bool isEven_;
  double low_, high_, acrossRow_, slope_ = 0, from_ = 0, to_ = 0;
};

/// A segment of a line with its neighbours, as in the segment shader: where a neighbour is nearer,
/// the neighbour draws the pixel, and ties belong to the earlier one.
class Segment {
 public:
  explicit Segment(const float* f)
      : piece_(f, f + 2),
        before_(f + 4, f),
        after_(f + 2, f + 6),
        hasBefore_(f[4] != f[0] || f[5] != f[1]),
        hasAfter_(f[6] != f[2] || f[7] != f[3]),
        from_{f[8], f[9], f[10], f[11]},
        change_{f[12] - f[8], f[13] - f[9], f[14] - f[10], f[15] - f[11]},
        width_(f[16]),
        half_(0.5F * std::max(width_, 1.0F) + 0.5F),
        faint_(std::min(width_, 1.0F)) {
    isFlat_ = change_[0] == 0 && change_[1] == 0 && change_[2] == 0 && change_[3] == 0;
    flat_ = toPaint(from_);
  }

  void draw(const Canvas& canvas) const {
    const double low = std::min(piece_.y, piece_.y + piece_.dy) - half_;
    const double high = std::max(piece_.y, piece_.y + piece_.dy) + half_;
    const int last = pixelAt(high, canvas.top, canvas.bottom);
    const double length = std::sqrt(double{piece_.dx} * piece_.dx + double{piece_.dy} * piece_.dy);
    const double alongX = length > 0 ? piece_.dx / length : 1;
    const double alongY = length > 0 ? piece_.dy / length : 0;
    const Band along(alongX, alongY, -half_, length + half_),
        across(-alongY, alongX, -half_, half_);
    for (int y = pixelAt(low, canvas.top, canvas.bottom); y < last; ++y) {
      const double row = y + 0.5 - piece_.y;
      double from = canvas.left - double{piece_.x}, to = canvas.right - double{piece_.x};
      along.limit(row, from, to);
      across.limit(row, from, to);
      const int left = pixelAt(from + piece_.x, canvas.left, canvas.right);
      const int right = pixelAt(to + piece_.x, canvas.left, canvas.right);
      for (int x = left; x < right; x += kTogether)
        drawPixels(canvas, x, std::min(kTogether, right - x), y);
    }
  }

 private:
  void drawPixels(const Canvas& canvas, int x, int count, int y) const {
    const float row = static_cast<float>(y) + 0.5F, first = static_cast<float>(x) + 0.5F;
    const Four columns = Four{0, 1, 2, 3} + first;
    const Four place = piece_.place(columns, row);
    const Four square = piece_.squareTo(columns, row, place);
    FourInts isOwn = square < Four{} + half_ * half_;
    if (hasBefore_) isOwn &= before_.square(columns, row) > square;
    if (hasAfter_) isOwn &= after_.square(columns, row) >= square;
    std::uint8_t* pixel = canvas.pixel(x, y);
    for (int i = 0; i < count; ++i, pixel += 4) {
      if (isOwn[i] == 0) continue;
      const float coverage = std::min(half_ - std::sqrt(square[i]), 1.0F) * faint_;
      Paint paint = isFlat_ ? flat_ : toPaint(from_ + change_ * place[i]);
      paint.weight *= coverage;
      blend(pixel, paint);
    }
  }

  Piece piece_, before_, after_;
  bool hasBefore_, hasAfter_;
  Four from_, change_;  // colours at its ends
  float width_;
  float half_;   // distance at which the coverage ends
  float faint_;  // coverage of a line narrower than a pixel
  bool isFlat_ = false;
  Paint flat_;
};

/// Fills the picture with its background, premultiplied.
void clear(const DrawList& list, Pixels& pixels) {
  const Rgba& c = list.background;
  const auto byte = [](float channel) {
    return static_cast<std::uint8_t>(std::clamp(channel, 0.0F, 1.0F) * 255 + 0.5F);
  };
  const std::array<std::uint8_t, 4> colour{byte(c.r * c.a), byte(c.g * c.a), byte(c.b * c.a),
                                           byte(c.a)};
  std::uint32_t word = 0;
  std::memcpy(&word, colour.data(), sizeof word);
  fill(pixels.rgba.data(), list.width * list.height, word);
}

class RasterContext : public PixelContext {
 public:
  std::string name() const override { return "raster"; }

  Pixels draw(const DrawList& list) override {
    checkPictureSize(list);
    Pixels pixels{list.width, list.height, {}};
    pixels.rgba.resize(std::size_t{4} * static_cast<std::size_t>(list.width) *
                       static_cast<std::size_t>(list.height));
    clear(list, pixels);
    flatten(list, geometry_);
    for (const DrawBatch& batch : geometry_.batches) {
      const ScissorBox& box = batch.scissor;
      const int top = list.height - box.y - box.height;
      const Canvas canvas{pixels.rgba.data(), list.width,      box.x, top,
                          box.x + box.width,  top + box.height};
      const float* triangle = geometry_.data.data() + batch.triangleOffset;
      for (std::size_t i = 0; i < batch.triangleCorners; i += 3, triangle += 3 * kTriangleFloats)
        drawTriangle(canvas, triangle);
      const float* segment = geometry_.data.data() + batch.segmentOffset;
      for (std::size_t i = 0; i < batch.segments; ++i, segment += kSegmentFloats)
        Segment(segment).draw(canvas);
    }
    return pixels;
  }

 private:
  Geometry geometry_;
};

}  // namespace

std::unique_ptr<PixelContext> makeRasterContext() {
  return std::make_unique<RasterContext>();
}

std::unique_ptr<PixelContext> makePixelContext(PixelBackend backend) {
  if (backend == PixelBackend::Egl) return makeEglContext();
  if (backend == PixelBackend::Osmesa) return makeOsmesaContext();
  return makeRasterContext();
}

PixelContext& contextOfThread() {
  thread_local const std::unique_ptr<PixelContext> context = makePixelContext();
  return *context;
}

void checkPictureSize(const DrawList& list) {
  constexpr int kLargest = 16384;  // pixels per side, the limit of OpenGL in software, too
  if (list.width <= 0 || list.height <= 0)
    throw std::runtime_error("A picture needs a width and a height of at least one pixel.");
  if (list.width > kLargest || list.height > kLargest)
    throw std::runtime_error("A picture may be at most " + std::to_string(kLargest) +
                             " pixels wide and high.");
}

}  // namespace asperity
