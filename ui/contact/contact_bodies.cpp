#include <algorithm>
#include <cmath>

#include "ui/contact/contact_parts.h"
#include "ui/contact/frame_curves.h"
#include "ui/draw/theme.h"

namespace asperity {
namespace {

using Curve = std::vector<CurveVertex>;

constexpr float kLongestStroke = 0.22F;  // of the plot's height, at the end of the scale

std::vector<DrawPoint> toPixels(const Curve& curve, const ContactLayout& layout) {
  std::vector<DrawPoint> points;
  points.reserve(curve.size());
  for (const CurveVertex& v : curve) points.push_back({layout.px(v.x), layout.py(v.height)});
  return points;
}

/// Fills the area below the curve with colours that depend on the row. Several columns together are
/// filled down to their lowest point, and one rectangle follows below: tall narrow rectangles are
/// slow to draw.
template <typename Shade>
void fillBelow(DrawLayer& layer, const std::vector<DrawPoint>& curve, float bottom,
               const Shade& shade) {
  constexpr std::size_t kTogether = 24;
  for (std::size_t first = 0; first + 1 < curve.size(); first += kTogether) {
    const std::size_t last = std::min(first + kTogether, curve.size() - 1);
    float low = curve[first].y;
    for (std::size_t i = first; i <= last; ++i) low = std::max(low, curve[i].y);
    for (std::size_t i = first; i < last; ++i) {
      const DrawPoint &a = curve[i], &b = curve[i + 1];
      addQuad(layer, {a.x, a.y, shade(a.y)}, {b.x, b.y, shade(b.y)}, {b.x, low, shade(low)},
              {a.x, low, shade(low)});
    }
    if (low < bottom)
      addRectangle(layer, {curve[first].x, low, curve[last].x - curve[first].x, bottom - low},
                   shade(low), shade(bottom));
  }
}

/// Adds a band of light along the upper edge of the body below the curve.
void addRim(DrawLayer& layer, const std::vector<DrawPoint>& curve, float depth) {
  const Rgba bright{1, 1, 1, 0.14F}, none{1, 1, 1, 0};
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const DrawPoint &a = curve[i], &b = curve[i + 1];
    addQuad(layer, {a.x, a.y, bright}, {b.x, b.y, bright}, {b.x, b.y + depth, none},
            {a.x, a.y + depth, none});
  }
}

/// Returns the lowest row of a curve within the plot; drawing further down, behind other bodies,
/// would be wasted.
float lowestRow(const std::vector<DrawPoint>& curve, const ContactLayout& layout) {
  float low = layout.plot.y;
  for (const DrawPoint& point : curve) low = std::max(low, point.y);
  return std::min(std::ceil(low) + 1, layout.plot.bottom());
}

/// Adds the usual hatching of a rigid body; the strokes move with the line.
void addHatching(DrawLayer& layer, const Frame& frame, const ContactLayout& layout, float bottom) {
  const Box& p = layout.plot;
  const double gap = std::round(13 * layout.sizes.unit);
  const double velocity = frame.scene ? frame.scene->sliding.velocity : 1;
  const double slid = velocity < 0 ? -std::abs(frame.distance) : frame.distance;
  double offset = std::fmod((slid - layout.view.left) * layout.pixelsPerMetreX(), gap);
  if (!std::isfinite(offset)) offset = 0;
  // The lines have one colour, so vector pictures can keep them as lines.
  const bool isPaper = layout.theme.isPaper;
  const Rgba colour = isPaper ? layout.theme.axis : withAlpha(layout.theme.rigidEdge, 0.15F);
  const float width = std::max(1.0F, (isPaper ? 0.7F : 1.0F) * layout.sizes.unit);
  for (double x = p.x + offset - gap; x < p.right() + p.height; x += gap) {
    const auto top = static_cast<float>(x), end = top - (bottom - p.y);
    addLine(layer, {{top, p.y}, {end, bottom}}, width, colour);
  }
}

DrawLayer rigidLayer(const Frame& frame, const Curve& line, const ContactLayout& layout) {
  DrawLayer layer;
  const Theme& t = layout.theme;
  const Box& p = layout.plot;
  const float bottom = lowestRow(toPixels(line, layout), layout);
  if (t.isPaper) {
    addRectangle(layer, {p.x, p.y, p.width, bottom - p.y}, t.rigid);
    addHatching(layer, frame, layout, bottom);
    return layer;
  }
  const Rgba high = mix(t.rigid, {1, 1, 1, 1}, 0.12F), low = mix(t.rigid, {0, 0, 0, 1}, 0.16F);
  addRectangle(layer, {p.x, p.y, p.width, bottom - p.y}, high,
               mix(high, low, (bottom - p.y) / p.height));
  addHatching(layer, frame, layout, bottom);
  return layer;
}

DrawLayer elastomerLayer(const Curve& line, const Curve& surface, const ContactLayout& layout) {
  DrawLayer layer;
  const Theme& t = layout.theme;
  const float bottom = layout.plot.bottom();
  const std::vector<DrawPoint> points = toPixels(surface, layout);
  fillBelow(layer, toPixels(line, layout), lowestRow(points, layout),
            [&](float) { return t.panel; });
  if (t.isPaper) {
    fillBelow(layer, points, bottom, [&](float) { return t.elastomer; });
    return layer;
  }
  const Rgba light = mix(t.elastomer, {1, 1, 1, 1}, 0.14F);
  const Rgba dark = mix(t.elastomer, {0, 0, 0, 1}, 0.34F);
  const auto shade = [&](float y) {
    return mix(light, dark, std::clamp((y - layout.plot.y) / layout.plot.height, 0.0F, 1.0F));
  };
  fillBelow(layer, points, bottom, shade);
  addRim(layer, points, 26 * layout.sizes.unit);
  return layer;
}

void addCurve(DrawLayer& layer, const Curve& curve, const ContactLayout& layout, float width,
              const Rgba& colour) {
  DrawLine line;
  line.width = width;
  line.vertices.reserve(curve.size());
  for (const CurveVertex& v : curve)
    line.vertices.push_back({layout.px(v.x), layout.py(v.height), colour});
  layer.lines.push_back(std::move(line));
}

/// Adds the grid over the bodies, but under the curves and contacts, which must keep their colours.
void addGrid(DrawLayer& layer, const ContactLayout& layout) {
  const float width = std::max(1.0F, std::round(layout.sizes.unit));
  for (const Tick& tick : layout.heightTicks.ticks)
    addRectangle(layer,
                 {layout.plot.x, std::floor(layout.py(tick.value)), layout.plot.width, width},
                 layout.theme.grid);
}

/// Adds the dashed level of the undeformed elastomer.
void addUndeformedLevel(DrawLayer& layer, const ContactLayout& layout) {
  const float u = layout.sizes.unit, y = layout.py(0);
  for (float x = layout.plot.x; x < layout.plot.right(); x += 12 * u)
    addLine(layer, {{x, y}, {x + 5 * u, y}}, std::max(1.0F, u),
            withAlpha(layout.theme.elastomerEdge, 0.55F));
}

/// Adds a wide faint line under a narrow bright one; a single point is a dot.
void addInterval(DrawLayer& layer, const Curve& interval, const ContactLayout& layout) {
  const float u = layout.sizes.unit;
  DrawLine core, halo;
  core.width = 3.6F * u;
  halo.width = 9 * u;
  for (const CurveVertex& v : interval) {
    const float x = layout.px(v.x), y = layout.py(v.height);
    const Rgba colour = layout.scale.colour(v.value);
    core.vertices.push_back({x, y, colour});
    halo.vertices.push_back({x, y, withAlpha(colour, 0.22F)});
  }
  layer.lines.push_back(std::move(halo));
  layer.lines.push_back(std::move(core));
}

/// Adds strokes under an interval at equal distances on the picture, each as long as the value
/// there; an interval that lies between two of them has one at its largest value.
void addStrokesBelow(DrawLayer& layer, const Curve& interval, const ContactLayout& layout) {
  const float u = layout.sizes.unit, longest = kLongestStroke * layout.plot.height;
  const float step = 3 * u, width = std::max(1.0F, 0.9F * u);
  const auto stroke = [&](float x, float y, double value) {
    const float length = longest * layout.scale.position(value);
    if (length > 0.5F) addLine(layer, {{x, y}, {x, y + length}}, width, layout.theme.text);
  };
  const CurveVertex* largest = nullptr;
  bool hasAny = false;
  for (std::size_t i = 0; i < interval.size(); ++i) {
    const CurveVertex& b = interval[i];
    if (!largest || b.value > largest->value) largest = &b;
    if (i == 0) continue;
    const CurveVertex& a = interval[i - 1];
    const float from = layout.px(a.x), to = layout.px(b.x);
    if (!(to > from)) continue;
    for (float x = std::ceil(from / step) * step; x < to; x += step) {
      const double part = (x - from) / (to - from);
      stroke(x, layout.py(std::lerp(a.height, b.height, part)), std::lerp(a.value, b.value, part));
      hasAny = true;
    }
  }
  if (!hasAny && largest) stroke(layout.px(largest->x), layout.py(largest->height), largest->value);
}

/// Draws the free surface in the colours of its age, with a band of them below. Nothing is drawn in
/// contact, and where contact has never occurred.
void addAge(DrawLayer& below, DrawLayer& curves, const Curve& surface,
            const ContactLayout& layout) {
  const float u = layout.sizes.unit, depth = 0.1F * layout.plot.height;
  DrawLine line;
  line.width = 3.6F * u;
  for (const CurveVertex& v : surface) {
    const bool isFree = v.value > 0 && std::isfinite(v.value);
    line.vertices.push_back({layout.px(v.x), layout.py(v.height),
                             withAlpha(layout.scale.colour(v.value), isFree ? 1.0F : 0.0F)});
  }
  for (std::size_t i = 0; i + 1 < line.vertices.size(); ++i) {
    const auto at = [&](const DrawVertex& v, float down, float alpha) {
      return DrawVertex{v.x, v.y + down, withAlpha(v.colour, v.colour.a * alpha)};
    };
    const DrawVertex &a = line.vertices[i], &b = line.vertices[i + 1];
    if (a.colour.a == 0 && b.colour.a == 0) continue;
    addQuad(below, at(a, 0, 0.55F), at(b, 0, 0.55F), at(b, depth, 0), at(a, depth, 0));
  }
  curves.lines.push_back(std::move(line));
}

/// Marks a contact that is too narrow for a line, in every period shown: bright on a dark rim.
void addMark(DrawLayer& layer, const Frame& frame, const ContactLayout& layout) {
  const std::size_t point = *layout.marked;
  const float u = layout.sizes.unit, y = layout.py(frame.surfaceHeight[point]);
  const std::vector<double>& values = overlayValues(frame, layout.scale.overlay);
  const double value = values.empty() ? 0 : values[point];
  const Rgba bright =
      layout.scale.isShown() && value > 0 ? layout.scale.colour(value) : layout.scale.colourAt(1);
  const double period = periodLength(frame);
  const double at = frame.spacing * static_cast<double>(point);
  for (double k = std::ceil((layout.view.left - at) / period);
       at + k * period <= layout.view.left + layout.view.width; ++k) {
    const DrawPoint centre{layout.px(at + k * period), y};
    addLine(layer, {centre}, 15 * u, withAlpha(bright, 0.3F));
    addLine(layer, {centre}, 9.5F * u, {0.07F, 0.1F, 0.14F, 1});
    addLine(layer, {centre}, 7 * u, bright);
  }
}

}  // namespace

// ---- The light below coloured parts of the elastomer's surface

float glowDepth(const ContactLayout& layout) {
  return 0.2F * layout.plot.height;
}

namespace {

constexpr int kRows = 12;

/// Values at equidistant positions across the plot.
class Strip {
 public:
  Strip(const ContactLayout& layout, float step)
      : left_(layout.plot.x),
        step_(step),
        values_(static_cast<std::size_t>(layout.plot.width / step) + 2) {}

  std::size_t size() const { return values_.size(); }
  float place(std::size_t i) const { return left_ + static_cast<float>(i) * step_; }
  float& operator[](std::size_t i) { return values_[i]; }
  float operator[](std::size_t i) const { return values_[i]; }

  /// Returns the nearest position, limited to the strip.
  std::size_t nearest(float x) const {
    const float i = std::round((x - left_) / step_);
    return static_cast<std::size_t>(std::clamp(i, 0.0F, static_cast<float>(values_.size() - 1)));
  }
  bool covers(float x) const { return x > left_ - step_ && x < place(values_.size() - 1) + step_; }

  void soften() {
    float before = values_.front();
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const float here = values_[i];
      const float after = i + 1 < values_.size() ? values_[i + 1] : here;
      values_[i] = 0.25F * before + 0.5F * here + 0.25F * after;
      before = here;
    }
  }

 private:
  float left_, step_;
  std::vector<float> values_;
};

/// Writes the surface's pixel row at every position of the strip.
void sampleSurface(Strip& rows, const std::vector<CurveVertex>& surface,
                   const ContactLayout& layout) {
  std::size_t k = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const float x = rows.place(i);
    while (k + 2 < surface.size() && layout.px(surface[k + 1].x) < x) ++k;
    const CurveVertex& a = surface[k];
    const CurveVertex& b = surface[std::min(k + 1, surface.size() - 1)];
    const float xa = layout.px(a.x), xb = layout.px(b.x);
    const float t = xb > xa ? std::clamp((x - xa) / (xb - xa), 0.0F, 1.0F) : 0;
    rows[i] = layout.py(a.height) + t * (layout.py(b.height) - layout.py(a.height));
  }
}

/// Writes positions on the colour scale; positions between the vertices of an interval are
/// interpolated.
void markInterval(Strip& shares, const std::vector<CurveVertex>& interval,
                  const ContactLayout& layout) {
  const auto share = [&](const CurveVertex& v) {
    return std::clamp(layout.scale.position(v.value), 0.02F, 1.0F);
  };
  const auto mark = [&](float x, float value) {
    if (shares.covers(x)) {
      float& there = shares[shares.nearest(x)];
      there = std::max(there, value);
    }
  };
  mark(layout.px(interval.front().x), share(interval.front()));
  for (std::size_t k = 0; k + 1 < interval.size(); ++k) {
    const float xa = layout.px(interval[k].x), xb = layout.px(interval[k + 1].x);
    const float pa = share(interval[k]), pb = share(interval[k + 1]);
    mark(xb, pb);
    if (!shares.covers(xb) && !shares.covers(xa) && (xa > 0) == (xb > 0)) continue;
    for (std::size_t i = shares.nearest(xa) + 1; i < shares.nearest(xb); ++i) {
      const float t = (shares.place(i) - xa) / (xb - xa);
      shares[i] = std::max(shares[i], pa + t * (pb - pa));
    }
  }
}

/// The position of the light (weight) and its brightness (weighted share), smoothed row by row.
struct Light {
  Strip weight, share;
  Rgba colour(std::size_t i, int row) const {
    const float w = weight[i];
    const float t = w > 0 ? share[i] / w : 0;
    const float fade = 1 - static_cast<float>(row) / kRows;
    // Like embers, the light gets redder with depth: yellow over the elastomer's blue would turn
    // green.
    const float warmth = t * (0.25F + 0.6F * fade * fade);
    return withAlpha(pressureColour(warmth), std::pow(w, 0.7F) * fade * fade * (0.45F + 0.5F * t));
  }
};

/// Adds triangles that start at the surface and fade with depth, in the colours of the contacts
/// above.
void addGlow(DrawLayer& layer, const std::vector<CurveVertex>& surface,
             const std::vector<std::vector<CurveVertex>>& contacts, const ContactLayout& layout) {
  if (contacts.empty() || surface.empty()) return;
  const float step = std::max(1.0F, 2 * layout.sizes.unit);
  Strip rows(layout, step);
  sampleSurface(rows, surface, layout);
  Light light{Strip(layout, step), Strip(layout, step)};
  for (const auto& interval : contacts) markInterval(light.share, interval, layout);
  for (std::size_t i = 0; i < light.weight.size(); ++i)
    light.weight[i] = light.share[i] > 0 ? 1.0F : 0.0F;

  const float rowHeight = glowDepth(layout) / kRows;
  Light next = light;
  for (int row = 0; row < kRows; ++row, light = next) {
    next.weight.soften();
    next.share.soften();
    const float down = static_cast<float>(row) * rowHeight;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
      if (light.weight[i] + light.weight[i + 1] + next.weight[i] + next.weight[i + 1] < 0.004F)
        continue;
      const float x0 = rows.place(i), x1 = rows.place(i + 1);
      const float y0 = rows[i] + down, y1 = rows[i + 1] + down;
      addQuad(layer, {x0, y0, light.colour(i, row)}, {x1, y1, light.colour(i + 1, row)},
              {x1, y1 + rowHeight, next.colour(i + 1, row + 1)},
              {x0, y0 + rowHeight, next.colour(i, row + 1)});
    }
  }
}

}  // namespace

// ---- Both bodies

void addBodies(DrawList& list, const Frame& frame, const ContactLayout& layout) {
  if (!isDrawable(frame)) return;
  const PointRange range = pointsWithin(frame, layout.view.left, layout.view.width);
  const Columns columns{layout.view.left, layout.pixelsPerMetreX()};
  const std::vector<double>& values = overlayValues(frame, layout.scale.overlay);
  const bool coloursAge = layout.scale.overlay == ContactOverlay::Relaxation;
  const Curve line = decimated(frame, frame.lineHeight, range, columns);
  const Curve surface = decimated(frame, frame.surfaceHeight, range, columns, values);
  // Two contacts closer than the width of a hairline cannot be distinguished.
  const double hairlines = columns.pixelsPerMetre / std::max(1.0F, layout.sizes.unit);
  std::vector<Curve> intervals;
  if (layout.scale.isShown() && !coloursAge)
    intervals = intervalsAbove(frame, range, {columns.left, hairlines}, values,
                               layout.scale.minimumShown());

  DrawLayer rigid = rigidLayer(frame, line, layout);
  DrawLayer elastomer = elastomerLayer(line, surface, layout);
  const bool isPaper = layout.theme.isPaper;
  if (!isPaper) addGlow(elastomer, surface, intervals, layout);
  DrawLayer curves;
  addGrid(curves, layout);
  addUndeformedLevel(curves, layout);
  const float width = layout.sizes.curve;
  addCurve(curves, surface, layout, width, layout.theme.elastomerEdge);
  addCurve(curves, line, layout, width, layout.theme.rigidEdge);
  if (coloursAge && layout.scale.isShown() && !isPaper) addAge(elastomer, curves, surface, layout);
  if (coloursAge && layout.scale.isShown() && isPaper) addStrokesBelow(curves, surface, layout);
  for (const Curve& interval : intervals)
    if (isPaper)
      addStrokesBelow(curves, interval, layout);
    else
      addInterval(curves, interval, layout);
  if (layout.marked && !isPaper) addMark(curves, frame, layout);
  for (DrawLayer* layer : {&rigid, &elastomer, &curves}) {
    layer->clip = layout.plot;
    list.layers.push_back(std::move(*layer));
  }
}

}  // namespace asperity
