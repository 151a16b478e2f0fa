#include "ui/chart/diagram_series.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "ui/draw/fonts.h"
#include "ui/draw/theme.h"

namespace asperity {
namespace {

constexpr float kErrorBar = 1.2F, kRim = 0.8F;  // units

bool holds(const Box& box, const DrawPoint& p) {
  constexpr float kEdge = 0.5F;  // tolerance for points at the very end of an axis
  return p.x >= box.x - kEdge && p.x <= box.right() + kEdge && p.y >= box.y - kEdge &&
         p.y <= box.bottom() + kEdge;
}

std::vector<DrawPoint> drawnPoints(const DiagramSeries& series, const DiagramAxes& axes) {
  std::vector<DrawPoint> points;
  points.reserve(series.points.size());
  for (const DiagramPoint& point : series.points)
    points.push_back(axes.mapToPosition(point.x, point.y));
  return points;
}

/// Returns the parts of a curve without gaps, with no more points in x than pixels.
std::vector<Polyline> curveRuns(const std::vector<DrawPoint>& points, const Box& box) {
  std::vector<Polyline> runs;
  bool open = false;
  for (const DrawPoint& place : points) {
    if (isFinite(place)) {
      if (!open) runs.emplace_back();
      runs.back().push_back(place);
    }
    open = isFinite(place);
  }
  const auto byX = [](const DrawPoint& a, const DrawPoint& b) { return a.x < b.x; };
  for (Polyline& run : runs)
    if (static_cast<float>(run.size()) > 2 * box.width &&
        std::is_sorted(run.begin(), run.end(), byX))
      run = thinned(run);
  return runs;
}

struct Bar {
  float x, low, high;  // pixels; low is the lower end, so the larger row
};

Bar errorBar(const DiagramPoint& point, const DiagramAxes& axes) {
  const DrawPoint high = axes.mapToPosition(point.x, point.high);
  return {high.x, axes.mapToPosition(point.x, point.low).y, high.y};
}

bool isDrawable(const Bar& bar) {
  return std::isfinite(bar.x) && std::isfinite(bar.low);
}

/// Returns one bar for each pixel column that encloses all bars there, where points are dense.
std::vector<Bar> thinnedBars(const DiagramSeries& series, const DiagramAxes& axes) {
  const bool isCrowded = static_cast<float>(series.points.size()) > 2 * axes.box.width;
  std::vector<Bar> bars;
  for (const DiagramPoint& point : series.points) {
    const Bar bar = errorBar(point, axes);
    const bool isJoined = isCrowded && !bars.empty() && isDrawable(bar) &&
                          isDrawable(bars.back()) && std::floor(bar.x) == std::floor(bars.back().x);
    if (!isJoined) {
      bars.push_back(bar);
      continue;
    }
    bars.back().low = std::max(bars.back().low, bar.low);
    bars.back().high = std::min(bars.back().high, bar.high);
  }
  return bars;
}

void addBand(DrawLayer& layer, const DiagramSeries& series, const SeriesStyle& style,
             const DiagramAxes& axes) {
  const Rgba fill = withAlpha(style.colour, kBandOpacity);
  const std::vector<Bar> bars = thinnedBars(series, axes);
  for (std::size_t i = 0; i + 1 < bars.size(); ++i) {
    const Bar &a = bars[i], &b = bars[i + 1];
    if (!isDrawable(a) || !isDrawable(b)) continue;
    addQuad(layer, {a.x, a.high, fill}, {b.x, b.high, fill}, {b.x, b.low, fill},
            {a.x, a.low, fill});
  }
}

void addBars(DrawLayer& layer, const DiagramSeries& series, const SeriesStyle& style,
             const DiagramAxes& axes, float unit) {
  const Box& box = axes.box;
  const float width = kErrorBar * unit, cap = std::max(2.2F * unit, 0.5F * style.markSize);
  for (const DiagramPoint& point : series.points) {
    const Bar bar = errorBar(point, axes);
    if (!isDrawable(bar)) continue;
    for (const Polyline& part : clippedTo(box, {{bar.x, bar.low}, {bar.x, bar.high}}))
      addLine(layer, part, width, style.colour);
    for (const float y : {bar.low, bar.high})
      for (const Polyline& part : clippedTo(box, {{bar.x - cap, y}, {bar.x + cap, y}}))
        addLine(layer, part, width, style.colour);
  }
}

void addCurve(DrawList& list, const DiagramSeries& series, const SeriesStyle& style,
              const DiagramAxes& axes, float unit, const Theme& theme, bool isOverField) {
  const Box& box = axes.box;
  DrawLayer lines, rims, marks;
  lines.clip = box;
  if (style.hasBars) addBars(lines, series, style, axes, unit);
  if (style.stroke != SeriesStroke::None)
    for (const Polyline& part : clippedCurve(series, axes)) {
      if (isOverField)
        addLine(lines, part, style.width + 2.4F * unit, withAlpha(theme.background, 0.7F));
      addStroke(lines, part, style);
    }
  if (style.mark != SeriesMark::None)
    for (const DrawPoint& place : drawnPoints(series, axes)) {
      if (!isFinite(place) || !holds(box, place)) continue;
      addMarkRim(rims, style.mark, place, style.markSize, kRim * unit, theme.background);
      addMark(marks, style.mark, place, style.markSize, style.colour);
    }
  for (DrawLayer* layer : {&lines, &rims, &marks})
    if (!layer->lines.empty() || !layer->triangles.empty())
      list.layers.push_back(std::move(*layer));
}

}  // namespace

std::vector<Polyline> clippedCurve(const DiagramSeries& series, const DiagramAxes& axes) {
  std::vector<Polyline> parts;
  for (const Polyline& run : curveRuns(drawnPoints(series, axes), axes.box))
    for (Polyline& part : clippedTo(axes.box, run)) parts.push_back(std::move(part));
  return parts;
}

std::vector<DrawPoint> thinned(const std::vector<DrawPoint>& points) {
  std::vector<DrawPoint> kept;
  if (points.empty()) return kept;
  kept.push_back(points.front());
  for (std::size_t first = 1, end = first; first + 1 < points.size(); first = end) {
    const float column = std::floor(points[first].x);
    std::size_t low = first, high = first;
    for (end = first; end + 1 < points.size() && std::floor(points[end].x) == column; ++end) {
      if (points[end].y < points[low].y) low = end;
      if (points[end].y > points[high].y) high = end;
    }
    kept.push_back(points[std::min(low, high)]);
    if (low != high) kept.push_back(points[std::max(low, high)]);
  }
  if (points.size() > 1) kept.push_back(points.back());
  return kept;
}

void addSeries(DrawList& list, const Diagram& diagram, const std::vector<SeriesStyle>& styles,
               const DiagramAxes& axes, const DiagramSizes& sizes, const Theme& theme) {
  DrawLayer bands;
  bands.clip = axes.box;
  for (std::size_t i = 0; i < diagram.series.size(); ++i)
    if (styles[i].isBand) addBand(bands, diagram.series[i], styles[i], axes);
  if (!bands.triangles.empty()) list.layers.push_back(std::move(bands));
  for (const bool theory : {true, false})
    for (std::size_t i = 0; i < diagram.series.size(); ++i)
      if (diagram.series[i].isTheory == theory)
        addCurve(list, diagram.series[i], styles[i], axes, sizes.unit, theme,
                 diagram.field.has_value());
}

void coverSeries(OccupancyGrid& map, const Diagram& diagram, const std::vector<SeriesStyle>& styles,
                 const DiagramAxes& axes) {
  for (std::size_t i = 0; i < diagram.series.size(); ++i) {
    const DiagramSeries& series = diagram.series[i];
    for (const DiagramPoint& point : series.points) {
      const Bar bar = errorBar(point, axes);
      const float half = markWidth(styles[i].mark, styles[i].markSize) / 2;
      if (isDrawable(bar))
        map.addBox({bar.x - half, bar.high, 2 * half, bar.low - bar.high},
                   styles[i].isBand ? 0.25F : 0.6F);
      const DrawPoint place = axes.mapToPosition(point.x, point.y);
      if (styles[i].mark != SeriesMark::None && isFinite(place))
        map.addBox({place.x - half, place.y - half, 2 * half, 2 * half}, 1);
    }
    if (styles[i].stroke != SeriesStroke::None)
      for (const Polyline& part : clippedCurve(series, axes)) map.addLine(part, 1);
  }
}

// ---- Horizontal bars

TickedAxis barAxis(const Diagram& diagram, float available, const DiagramSizes& sizes) {
  TickedAxis axis;
  const auto count = static_cast<double>(diagram.bars.size());
  axis.range = {0, std::max(count, 1.0)};
  for (std::size_t i = 0; i < diagram.bars.size(); ++i)
    axis.ticks.push_back({count - static_cast<double>(i) - 0.5,
                          elided(diagram.bars[i].name.text, sizes.tick, false, available)});
  return axis;
}

namespace {

/// Adds the interval of a horizontal bar with caps of half the height `cap`; an end beyond the box
/// is an arrow at its edge.
void addInterval(DrawLayer& layer, float low, float high, float y, float cap, const Box& box,
                 float width, const Rgba& ink) {
  const float left = std::max(low, box.x), right = std::min(high, box.right());
  if (!(left < right)) return;
  for (const auto& [from, to, isCut] :
       {std::tuple{right, left, low < box.x}, {left, right, high > box.right()}}) {
    if (isCut)
      addArrow(layer, {from, y}, {to + (to < from ? width : -width), y}, 1.5F * cap, width, ink);
    else
      addLine(layer, {{to, y - cap}, {to, y + cap}}, width, ink);
  }
  addLine(layer, {{left, y}, {right, y}}, width, ink);
}

}  // namespace

void addHorizontalBars(DrawList& list, const Diagram& diagram, const DiagramAxes& axes,
                       const DiagramSizes& sizes, const Theme& theme) {
  if (diagram.bars.empty()) return;
  constexpr float kThick = 0.62F;  // of the distance between two
  constexpr float kPale = 0.65F;   // share of the background
  const Box& box = axes.box;
  const float row = box.height / static_cast<float>(diagram.bars.size());
  const float half = std::min(kThick * row, 2.2F * sizes.tick) / 2;
  const float zero = std::clamp(axes.px(0), box.x, box.right());
  DrawLayer layer;
  layer.clip = box;
  for (std::size_t i = 0; i < diagram.bars.size(); ++i) {
    const DiagramBar& bar = diagram.bars[i];
    const float end = axes.px(bar.value);
    const float y = box.y + (static_cast<float>(i) + 0.5F) * row;
    const Rgba colour = seriesColour(bar.value < 0 ? 1 : 0, theme);
    addRectangle(layer, {std::min(zero, end), y - half, std::abs(end - zero), 2 * half},
                 bar.isSignificant() ? colour : mix(colour, theme.background, kPale));
    if (!std::isfinite(bar.error)) continue;
    addInterval(layer, axes.px(bar.value - bar.error), axes.px(bar.value + bar.error), y,
                0.5F * half, box, 1.4F * sizes.unit,
                bar.isSignificant() ? theme.text : theme.faintText);
  }
  addLine(layer, {{zero, box.y}, {zero, box.bottom()}}, 1.2F * sizes.unit, theme.text);
  list.layers.push_back(std::move(layer));
}

}  // namespace asperity
