#include "ui/chart/diagram_style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ui/draw/shapes.h"

namespace asperity {
namespace {

// Blue, vermilion, green, purple, orange, sky blue, and for Okabe and Ito's yellow an olive on
// white; then two colours far from all of these for every colour vision, on dark with a contrast
// of 3 also with the tint of region IV.
constexpr std::array<Rgba, kDistinctColours> kOnLight = {
    colourFrom(0x0072B2), colourFrom(0xD55E00), colourFrom(0x009E73),
    colourFrom(0xB85C96), colourFrom(0xD98C00), colourFrom(0x3FA0DC),
    colourFrom(0x6B6100), colourFrom(0x4818E0), colourFrom(0x201060)};
constexpr std::array<Rgba, kDistinctColours> kOnDark = {
    colourFrom(0x56B4E9), colourFrom(0xFF8A3D), colourFrom(0x22C294),
    colourFrom(0xDD8FBC), colourFrom(0xF0E442), colourFrom(0x5C8DF0),
    colourFrom(0xC9A26B), colourFrom(0x735FFF), colourFrom(0xD65030)};

constexpr double kDarkEnd = 0.18, kLightEnd = 0.82;  // part that is visible on dark and on white

}  // namespace

Rgba seriesColour(int index, const Theme& theme) {
  const auto position = static_cast<std::size_t>(std::max(index, 0) % kDistinctColours);
  return isDark(theme) ? kOnDark[position] : kOnLight[position];
}

Rgba rampColour(double t, const Theme& theme) {
  const bool dark = isDark(theme);
  const double from = dark ? kDarkEnd : 0, to = dark ? 1 : kLightEnd;
  const double clamped = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0);
  return fieldColour(from + clamped * (to - from));
}

Rgba fieldColour(double t) {
  const double clamped = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0);
  const double position = clamped * (kViridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(position), kViridis.size() - 2);
  return mix(kViridis[below], kViridis[below + 1],
             static_cast<float>(position - static_cast<double>(below)));
}

// ---- Marks

namespace {

constexpr float kRingSize = 1.9F;  // relative to the other marks' size
constexpr int kRingSides = 32;

void addRing(DrawLayer& layer, DrawPoint at, float size, const Rgba& colour) {
  const float width = std::max(1.0F, 0.2F * size),
              r = (markWidth(SeriesMark::Ring, size) - width) / 2;
  std::vector<DrawPoint> circle;
  for (int i = 0; i <= kRingSides; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kRingSides;
    circle.push_back({at.x + r * std::cos(angle), at.y + r * std::sin(angle)});
  }
  addLine(layer, circle, width, colour);
}

/// Returns the width of the line around a mark; it gives the triangles a smooth edge.
float edgeWidth(float size) {
  return std::min(1.5F, 0.3F * size);
}

std::vector<DrawPoint> closed(std::vector<DrawPoint> corners) {
  corners.push_back(corners.front());
  return corners;
}

}  // namespace

std::vector<DrawPoint> markCorners(SeriesMark mark, DrawPoint at, float size) {
  const float r = size / 2;
  const auto shifted = [&](std::initializer_list<DrawPoint> offsets) {
    std::vector<DrawPoint> corners;
    for (const DrawPoint& o : offsets) corners.push_back({at.x + r * o.x, at.y + r * o.y});
    return corners;
  };
  switch (mark) {
    case SeriesMark::Square:
      return shifted({{-0.89F, -0.89F}, {0.89F, -0.89F}, {0.89F, 0.89F}, {-0.89F, 0.89F}});
    case SeriesMark::Triangle:
      return shifted({{0, -1.28F}, {1.14F, 0.7F}, {-1.14F, 0.7F}});
    case SeriesMark::Diamond:
      return shifted({{0, -1.3F}, {1.16F, 0}, {0, 1.3F}, {-1.16F, 0}});
    case SeriesMark::None:
    case SeriesMark::Circle:
    case SeriesMark::Ring:
      break;
  }
  return {};
}

float markWidth(SeriesMark mark, float size) {
  return mark == SeriesMark::Ring ? kRingSize * size : size;
}

void addMark(DrawLayer& layer, SeriesMark mark, DrawPoint at, float size, const Rgba& colour) {
  if (mark == SeriesMark::None) return;
  if (mark == SeriesMark::Circle) return addLine(layer, {at}, size, colour);
  if (mark == SeriesMark::Ring) return addRing(layer, at, size, colour);
  const float edge = edgeWidth(size);
  const std::vector<DrawPoint> corners = markCorners(mark, at, size - edge);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    for (const DrawPoint& p : {corners[0], corners[i], corners[i + 1]})
      layer.triangles.push_back({p.x, p.y, colour});
  addLine(layer, closed(corners), edge, colour);
}

void addMarkRim(DrawLayer& layer, SeriesMark mark, DrawPoint at, float size, float rim,
                const Rgba& colour) {
  if (mark == SeriesMark::None || mark == SeriesMark::Ring)
    return;  // the enclosed mark stays visible
  if (mark == SeriesMark::Circle) return addLine(layer, {at}, size + 2 * rim, colour);
  addLine(layer, closed(markCorners(mark, at, size)), 2 * rim, colour);
}

// ---- Series

namespace {

// These are in units.
constexpr float kCurveWidth = 2, kRampCurveWidth = 1.7F, kTheoryWidth = 1.4F;
constexpr float kLargestMark = 7.2F, kSmallestMark = 3.6F;
// These are in line widths.
constexpr float kDash = 3.6F, kDashGap = 2.6F, kDotGap = 2.3F;

}  // namespace

bool hasErrorBars(const DiagramSeries& series) {
  return !series.isBand && std::ranges::any_of(series.points, [](const DiagramPoint& point) {
    return point.high > point.low;
  });
}

bool hasPoints(const DiagramSeries& series, const Diagram& diagram) {
  return std::ranges::any_of(
      series.points, [&](const DiagramPoint& point) { return hasPosition(diagram, point); });
}

std::vector<SeriesStyle> seriesStyles(const Diagram& diagram, const DiagramSizes& sizes,
                                      const Theme& theme, float pixels) {
  std::vector<SeriesStyle> styles;
  int next = 0;
  for (const DiagramSeries& series : diagram.series) {
    SeriesStyle style;
    const bool onRamp = std::isfinite(series.ramp);
    const int before = next;
    if (series.isTheory)
      style.colour = theme.text;
    else if (onRamp)
      style.colour = rampColour(series.ramp, theme);
    else
      style.colour = seriesColour(series.colour >= 0 ? series.colour : next++, theme);
    if (series.rgb) {
      style.colour = colourFrom(*series.rgb);
      next = before;
    }
    if (series.isFaded) style.colour = mix(theme.background, style.colour, kFadedOpacity);
    const float usual = sizes.curve > 0 ? sizes.curve / kCurveWidth : sizes.unit;
    style.width = (series.isTheory ? kTheoryWidth : onRamp ? kRampCurveWidth : kCurveWidth) * usual;
    style.stroke = series.stroke;
    // Series that share a colour have different strokes.
    if (next > kDistinctColours && series.colour < 0 && style.stroke == SeriesStroke::Solid)
      style.stroke = SeriesStroke::Dashed;
    style.mark = series.mark;
    const float apart = pixels / static_cast<float>(series.points.size() + 1);
    style.markSize =
        std::clamp(0.55F * apart, kSmallestMark * sizes.unit, kLargestMark * sizes.unit);
    style.isBand = series.isBand;
    style.hasBars = hasErrorBars(series);
    styles.push_back(style);
  }
  return styles;
}

void addStroke(DrawLayer& layer, const std::vector<DrawPoint>& points, const SeriesStyle& style) {
  const float w = style.width;
  switch (style.stroke) {
    case SeriesStroke::None:
      return;
    case SeriesStroke::Solid:
      return addLine(layer, points, w, style.colour);
    case SeriesStroke::Dashed:
      // The round ends of a dash make it one width longer, and the gap one width shorter.
      for (Polyline& dash : dashed(points, (kDash - 1) * w, (kDashGap + 1) * w))
        addLine(layer, std::move(dash), w, style.colour);
      return;
    case SeriesStroke::Dotted:
      for (Polyline& dot : dashed(points, 0, kDotGap * w))
        addLine(layer, std::move(dot), 1.15F * w, style.colour);
      return;
  }
}

}  // namespace asperity
