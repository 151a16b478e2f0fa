#include "ui/chart/diagram_legend.h"

#include <algorithm>
#include <cmath>

#include "ui/chart/diagram_colours.h"
#include "ui/chart/marks.h"
#include "ui/draw/colours.h"
#include "ui/draw/text_metrics.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

// In sizes of the font.
constexpr float kSample = 2.4F, kGap = 0.6F, kRow = 1.5F, kPad = 0.6F, kBetween = 1.4F;
constexpr float kBar = 6, kBarHeight = 0.8F;
constexpr int kBarSteps = 48;

bool sameLook(const SeriesStyle& a, const SeriesStyle& b) {
  return a.stroke == b.stroke && a.mark == b.mark && a.isBand == b.isBand &&
         a.colour.r == b.colour.r && a.colour.g == b.colour.g && a.colour.b == b.colour.b;
}

/// Data, then theory; what looks and is named alike once.
std::vector<LegendEntry> entriesOf(const Diagram& diagram, const std::vector<SeriesStyle>& styles) {
  std::vector<LegendEntry> entries;
  const auto add = [&](std::size_t i) {
    const DiagramSeries& series = diagram.series[i];
    if (series.name.empty() || (diagram.ramp && std::isfinite(series.ramp))) return;
    const bool known = std::any_of(entries.begin(), entries.end(), [&](const LegendEntry& entry) {
      return entry.name == series.name && sameLook(entry.style, styles[i]);
    });
    if (!known) entries.push_back({series.name, styles[i], true});
  };
  for (const bool theory : {false, true})
    for (std::size_t i = 0; i < diagram.series.size(); ++i)
      if (diagram.series[i].isTheory == theory) add(i);
  return entries;
}

float rampWidth(const DiagramRamp& ramp, float size) {
  const float ends = textWidth(ramp.from, size) + textWidth(ramp.to, size);
  return std::max(textWidth(ramp.title, size), ends + (kBar + 2 * kGap) * size);
}

float rampHeight(const DiagramRamp& ramp, float size) {
  return (ramp.title.empty() ? 1 : 2) * kRow * size;
}

/// Of the entries in their columns.
float entriesWidth(const Legend& legend) {
  if (legend.entries.empty()) return 0;
  const auto columns = static_cast<float>(legend.columns);
  return columns * legend.columnWidth + (columns - 1) * kBetween * legend.size;
}

void measure(Legend& legend) {
  float names = 0;
  for (const LegendEntry& entry : legend.entries)
    names = std::max(names, textWidth(entry.name, legend.size) +
                                (entry.hasSample ? 0 : -(kSample + kGap) * legend.size));
  const std::size_t count = legend.entries.size();
  const auto columns = static_cast<std::size_t>(legend.columns);
  legend.rows = (count + columns - 1) / columns;
  legend.columnWidth = (kSample + kGap) * legend.size + std::max(0.0F, names);
  float width = entriesWidth(legend);
  legend.height = static_cast<float>(legend.rows) * kRow * legend.size;
  if (legend.ramp) {
    width = std::max(width, rampWidth(*legend.ramp, legend.size));
    legend.height += rampHeight(*legend.ramp, legend.size);
  }
  legend.width = std::ceil(width + 2 * kPad * legend.size);
  legend.height = std::ceil(legend.height + 1.2F * kPad * legend.size);
}

/// Names cut to what one of so many columns has room for.
void shortenNames(Legend& legend, float width) {
  const auto columns = static_cast<float>(legend.columns);
  const float column =
      (width - 2 * kPad * legend.size - (columns - 1) * kBetween * legend.size) / columns;
  for (LegendEntry& entry : legend.entries) {
    std::string name =
        elided(entry.name, legend.size, false, column - (kSample + kGap) * legend.size);
    legend.isWhole = legend.isWhole && name == entry.name;
    entry.name = std::move(name);
  }
}

/// Only as many entries as the height has room for, and how many are missing.
void dropEntries(Legend& legend, float height) {
  const float room = height - 1.2F * kPad * legend.size -
                     (legend.ramp ? rampHeight(*legend.ramp, legend.size) : 0);
  const auto rows = static_cast<std::size_t>(std::max(0.0F, room / (kRow * legend.size)));
  const std::size_t places = rows * static_cast<std::size_t>(legend.columns);
  if (legend.entries.size() <= places) return;
  const std::size_t kept = places > 0 ? places - 1 : 0;
  const std::size_t missing = legend.entries.size() - kept;
  legend.isWhole = false;
  legend.entries.resize(kept);
  if (places > 0)
    legend.entries.push_back(
        {filled(Words::tr("and %1 more"), {std::to_string(missing)}), {}, false});
}

void addSample(DrawLayer& lines, DrawLayer& marks, const LegendEntry& entry, Place left,
               float size) {
  if (!entry.hasSample) return;
  const SeriesStyle& style = entry.style;
  const float length = kSample * size, y = left.y;
  if (style.isBand)
    addRectangle(lines, {left.x, y - 0.36F * size, length, 0.72F * size},
                 withAlpha(style.colour, 0.2F));
  const Place middle{left.x + length / 2, y};
  if (style.hasBars)
    addLine(lines, {{middle.x, y - 0.5F * size}, {middle.x, y + 0.5F * size}}, 0.6F * style.width,
            style.colour);
  const float inset = style.width / 2;  // round ends
  addStroke(lines, {{left.x + inset, y}, {left.x + length - inset, y}}, style);
  addMark(marks, style.mark, middle, std::min(style.markSize, 0.75F * size), style.colour);
}

/// Title, then the colours between the names of their ends.
void addRamp(DrawList& list, DrawLayer& layer, const DiagramRamp& ramp, Place at, float width,
             float size, const Theme& theme) {
  if (!ramp.title.empty()) {
    addLabel(list, elided(ramp.title, size, false, width), {at.x, std::round(at.y + 1.1F * size)},
             size, TextAnchor::Left, theme.text);
    at.y += kRow * size;
  }
  const float baseline = std::round(at.y + 1.1F * size);
  addLabel(list, ramp.from, {at.x, baseline}, size, TextAnchor::Left, theme.text);
  const float left = at.x + textWidth(ramp.from, size) + kGap * size;
  const float bar = kBar * size, top = baseline - 0.36F * size - kBarHeight * size / 2;
  for (int i = 0; i < kBarSteps; ++i) {  // each to the right end: no seams between them
    const float done = bar * static_cast<float>(i) / kBarSteps;
    addRectangle(layer, {left + done, top, bar - done, kBarHeight * size},
                 rampColour((i + 0.5) / kBarSteps, theme));
  }
  addLabel(list, ramp.to, {left + bar + kGap * size, baseline}, size, TextAnchor::Left, theme.text);
}

}  // namespace

Legend legendFor(const Diagram& diagram, const std::vector<SeriesStyle>& styles, float size,
                 float width, float height) {
  Legend legend;
  legend.entries = entriesOf(diagram, styles);
  legend.ramp = diagram.ramp;
  legend.size = size;
  if (legend.empty()) return legend;
  measure(legend);
  // More columns where there are too many rows and the width allows it.
  while (legend.height > height && legend.columns < 4) {
    Legend wider = legend;
    ++wider.columns;
    measure(wider);
    if (wider.width > width) break;
    legend = wider;
  }
  if (legend.width > width) shortenNames(legend, width);
  if (legend.ramp && rampWidth(*legend.ramp, size) + 2 * kPad * size > width) legend.ramp.reset();
  dropEntries(legend, height);
  measure(legend);
  return legend;
}

Legend legendOver(const Diagram& diagram, const std::vector<SeriesStyle>& styles, float size,
                  float width) {
  constexpr int kMostColumns = 6;
  Legend legend;
  legend.entries = entriesOf(diagram, styles);
  legend.ramp = diagram.ramp;
  legend.size = size;
  const int count = static_cast<int>(std::min<std::size_t>(legend.entries.size(), kMostColumns));
  for (legend.columns = std::max(1, count); legend.columns > 0; --legend.columns) {
    measure(legend);
    if (legend.width <= width) return legend;
  }
  legend.isWhole = false;
  return legend;
}

void addLegend(DrawList& list, const Legend& legend, const Box& box, bool framed,
               const DiagramSizes& sizes, const Theme& theme) {
  DrawLayer plate, lines, marks;
  const float size = legend.size, pad = kPad * size;
  if (framed) {
    addRectangle(plate, box, withAlpha(theme.background, 0.86F));
    addFrame(plate, box, withAlpha(theme.axis, 0.45F), std::max(1.0F, 0.8F * sizes.unit));
  }
  float top = box.y + 0.6F * pad;
  if (legend.ramp) {
    addRamp(list, lines, *legend.ramp, {box.x + pad, top}, box.width - 2 * pad, size, theme);
    top += rampHeight(*legend.ramp, size);
  }
  for (std::size_t i = 0; i < legend.entries.size(); ++i) {
    const auto column = static_cast<float>(i / legend.rows);
    const auto row = static_cast<float>(i % legend.rows);
    const float x = box.x + pad + column * (legend.columnWidth + kBetween * size);
    const float baseline = std::round(top + row * kRow * size + 1.1F * size);
    const LegendEntry& entry = legend.entries[i];
    addSample(lines, marks, entry, {x, baseline - 0.36F * size}, size);
    const float left = x + (entry.hasSample ? (kSample + kGap) * size : 0);
    addLabel(list, entry.name, {left, baseline}, size, TextAnchor::Left,
             entry.hasSample ? theme.text : theme.faintText);
  }
  for (DrawLayer* layer : {&plate, &lines, &marks})
    if (!layer->lines.empty() || !layer->triangles.empty())
      list.layers.push_back(std::move(*layer));
}

}  // namespace asperity
