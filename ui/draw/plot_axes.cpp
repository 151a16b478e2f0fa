#include "ui/draw/plot_axes.h"

#include <algorithm>
#include <cmath>

#include "ui/draw/fonts.h"
#include "ui/draw/log_ticks.h"

namespace asperity {
namespace {

constexpr float kQuarterTurn = 1.57079633F;

int tickCount(float pixels, float each) {
  return std::clamp(static_cast<int>(pixels / each), 2, 12);
}

PictureAxis axisOf(double from, double to, const AxisTicks& ticks, const std::string& name) {
  PictureAxis axis{
      from, to, {}, titleWithUnit(name, ticks.unit), ticks.unit, minorTicks(ticks, from, to)};
  for (const Tick& tick : ticks.ticks) axis.ticks.push_back({tick.value, tick.label});
  return axis;
}

/// The title that fits, the short one smaller where it must: the unit is never left out.
void addTitleWithin(DrawList& list, const PictureAxis& axis, Place at, float pixels, float size,
                    const Rgba& colour, float angle) {
  constexpr float kLeast = 7;
  const bool fits = textWidth(axis.title, size) <= pixels;
  const std::string& title = fits || axis.shortTitle.empty() ? axis.title : axis.shortTitle;
  while (textWidth(title, size) > pixels && size - 1 >= kLeast) size -= 1;
  addLabel(list, title, at, size, TextAnchor::Centre, colour, angle);
}

}  // namespace

AxisTicks roomyTicks(double from, double to, float pixels, float size, std::string_view unit) {
  for (int most = tickCount(pixels, size * 4); most > 1; --most) {
    AxisTicks axis = linearTicks(from, to, most, unit);
    if (axis.ticks.size() < 2) return axis;
    float widest = 0;
    for (const Tick& tick : axis.ticks) widest = std::max(widest, textWidth(tick.label, size));
    const double share = (axis.ticks[1].value - axis.ticks[0].value) / (to - from);
    if (widest + size < share * pixels) return axis;
  }
  return linearTicks(from, to, 1, unit);
}

PictureAxis linearAxisAlong(double from, double to, float pixels, float size,
                            const std::string& name, std::string_view unit) {
  return axisOf(from, to, roomyTicks(from, to, pixels, size, unit), name);
}

AxisTicks ticksUp(double from, double to, float pixels, float each, float size,
                  std::string_view unit) {
  int most = tickCount(pixels, each);
  AxisTicks axis = linearTicks(from, to, most, unit);
  // In steps of 1, 2 and 5 the next more are up to five times as many.
  constexpr int kMost = 12;
  while (axis.ticks.size() < 2 && most < kMost) {
    AxisTicks closer = linearTicks(from, to, ++most, unit);
    if (closer.ticks.size() < 2) continue;
    const double apart = (closer.ticks[1].value - closer.ticks[0].value) / (to - from);
    if (apart * static_cast<double>(pixels) < 1.1 * static_cast<double>(size)) break;
    axis = std::move(closer);
  }
  return axis;
}

PictureAxis linearAxisUp(double from, double to, float pixels, float size, const std::string& name,
                         std::string_view unit) {
  return axisOf(from, to, ticksUp(from, to, pixels, 4 * size, size, unit), name);
}

PictureAxis logarithmicAxis(double from, double to, int most, std::string title,
                            std::string shortTitle) {
  PictureAxis axis{from, to, {}, std::move(title), std::move(shortTitle), {}};
  for (const LogTick& tick : logTicks(from, to, most))
    axis.ticks.push_back({tick.decade, tick.label});
  return axis;
}

float widestLabel(const PictureAxis& axis, float size) {
  float widest = 0;
  for (const PlotTick& tick : axis.ticks) widest = std::max(widest, textWidth(tick.label, size));
  return widest;
}

float PlotAxes::px(double x) const {
  return box.x + static_cast<float>((x - along.from) / (along.to - along.from)) * box.width;
}

float PlotAxes::py(double y) const {
  return box.bottom() - static_cast<float>((y - up.from) / (up.to - up.from)) * box.height;
}

std::string titleWithUnit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " (" + unit + ")";
}

void addGridLines(DrawLayer& layer, const PlotAxes& axes, const Theme& theme, float unit) {
  const Box& box = axes.box;
  for (const PlotTick& tick : axes.up.ticks)
    addLine(layer, {{box.x, axes.py(tick.value)}, {box.right(), axes.py(tick.value)}}, unit,
            theme.grid);
  for (const PlotTick& tick : axes.along.ticks)
    addLine(layer, {{axes.px(tick.value), box.y}, {axes.px(tick.value), box.bottom()}}, unit,
            theme.grid);
}

void addFrame(DrawLayer& layer, const Box& box, const Rgba& colour, float width) {
  addLine(layer,
          {{box.x, box.y},
           {box.right(), box.y},
           {box.right(), box.bottom()},
           {box.x, box.bottom()},
           {box.x, box.y}},
          width, colour);
}

void addTickMarks(DrawLayer& layer, const PlotAxes& axes, const Rgba& colour, float width,
                  float length) {
  const Box& box = axes.box;
  const auto along = [&](double value, float reach) {
    const float x = axes.px(value);
    addLine(layer, {{x, box.bottom()}, {x, box.bottom() - reach}}, width, colour);
    addLine(layer, {{x, box.y}, {x, box.y + reach}}, width, colour);
  };
  const auto up = [&](double value, float reach) {
    const float y = axes.py(value);
    addLine(layer, {{box.x, y}, {box.x + reach, y}}, width, colour);
    addLine(layer, {{box.right(), y}, {box.right() - reach, y}}, width, colour);
  };
  for (const PlotTick& tick : axes.along.ticks) along(tick.value, length);
  for (const double value : axes.along.minor) along(value, length / 2);
  for (const PlotTick& tick : axes.up.ticks) up(tick.value, length);
  for (const double value : axes.up.minor) up(value, length / 2);
}

void addTickLabels(DrawList& list, const PlotAxes& axes, const Rgba& colour, float size) {
  const Box& box = axes.box;
  for (const PlotTick& tick : axes.along.ticks) {
    const float half = textWidth(tick.label, size) / 2;
    const float centre = std::min(axes.px(tick.value), static_cast<float>(list.width) - half - 2);
    addLabel(list, tick.label, {centre, box.bottom() + 1.5F * size}, size, TextAnchor::Centre,
             colour);
  }
  for (const PlotTick& tick : axes.up.ticks)
    addLabel(list, tick.label, {box.x - 0.7F * size, axes.py(tick.value) + 0.36F * size}, size,
             TextAnchor::Right, colour);
}

void addPlotAxes(DrawList& list, const PlotAxes& axes, const Theme& theme, float size, float unit) {
  const Box& box = axes.box;
  DrawLayer layer;
  addGridLines(layer, axes, theme, unit);
  addFrame(layer, box, theme.axis, unit);
  list.layers.push_back(std::move(layer));
  addTickLabels(list, axes, theme.faintText, size);
  addTitleWithin(list, axes.along, {box.x + box.width / 2, box.bottom() + 3 * size}, box.width,
                 size, theme.text, 0);
  addTitleWithin(list, axes.up, {1.5F * size, box.y + box.height / 2}, box.height, size, theme.text,
                 kQuarterTurn);
}

}  // namespace asperity
