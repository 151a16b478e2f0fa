#include "ui/chart/diagram_bars.h"

#include <algorithm>
#include <cmath>

#include "core/chart/sensitivity_sheet.h"
#include "ui/chart/diagram_colours.h"
#include "ui/draw/fonts.h"

namespace asperity {

TickedAxis barAxis(const Diagram& diagram, float room, const DiagramSizes& sizes) {
  TickedAxis axis;
  const auto count = static_cast<double>(diagram.bars.size());
  axis.range = {0, std::max(count, 1.0)};
  for (std::size_t i = 0; i < diagram.bars.size(); ++i)
    axis.ticks.push_back({count - static_cast<double>(i) - 0.5,
                          elided(diagram.bars[i].name.text, sizes.tick, false, room)});
  return axis;
}

void addBars(DrawList& list, const Diagram& diagram, const DiagramAxes& axes,
             const DiagramSizes& sizes, const Theme& theme) {
  if (diagram.bars.empty()) return;
  constexpr float kThick = 0.62F;  // of the distance between two
  constexpr float kPale = 0.65F;   // share of the background
  const Box& box = axes.box;
  const float row = box.height / static_cast<float>(diagram.bars.size());
  const float half = std::min(kThick * row, 2.2F * sizes.tick) / 2;
  const float zero = std::clamp(axes.px(0), box.x, box.right());
  DrawLayer layer;
  layer.clip = {box.x, box.y, box.width, box.height};
  for (std::size_t i = 0; i < diagram.bars.size(); ++i) {
    const DiagramBar& bar = diagram.bars[i];
    const float end = axes.px(bar.value);
    const float y = box.y + (static_cast<float>(i) + 0.5F) * row;
    const Rgba colour = seriesColour(bar.value < 0 ? 1 : 0, theme);
    addRectangle(layer, {std::min(zero, end), y - half, std::abs(end - zero), 2 * half},
                 isSignificant(bar) ? colour : mix(colour, theme.background, kPale));
    if (!std::isfinite(bar.error)) continue;
    const float low = axes.px(bar.value - bar.error), high = axes.px(bar.value + bar.error);
    const float cap = 0.5F * half;
    const Rgba ink = isSignificant(bar) ? theme.text : theme.faintText;
    addLine(layer, {{low, y}, {high, y}}, 1.4F * sizes.unit, ink);
    for (const float x : {low, high})
      addLine(layer, {{x, y - cap}, {x, y + cap}}, 1.4F * sizes.unit, ink);
  }
  addLine(layer, {{zero, box.y}, {zero, box.bottom()}}, 1.2F * sizes.unit, theme.text);
  list.layers.push_back(std::move(layer));
}

}  // namespace asperity
