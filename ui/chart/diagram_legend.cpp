#include "ui/chart/diagram_legend.h"

#include <algorithm>
#include <cmath>

#include "ui/draw/fonts.h"
#include "ui/draw/theme.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

// These are in sizes of the font.
constexpr float kSampleWidth = 2.4F, kEntryGap = 0.6F, kRow = 1.5F, kPad = 0.6F, kBetween = 1.4F;
constexpr float kRampLength = 6, kRampHeight = 0.8F;
constexpr int kBarSteps = 48;

bool isSameStyle(const SeriesStyle& a, const SeriesStyle& b) {
  return a.stroke == b.stroke && a.mark == b.mark && a.isBand == b.isBand &&
         a.colour.r == b.colour.r && a.colour.g == b.colour.g && a.colour.b == b.colour.b;
}

/// Returns the entries of data, then theory; entries with the same appearance and name appear once.
std::vector<LegendEntry> legendEntries(const Diagram& diagram,
                                       const std::vector<SeriesStyle>& styles) {
  std::vector<LegendEntry> entries;
  const auto add = [&](std::size_t i) {
    const DiagramSeries& series = diagram.series[i];
    if (series.name.empty() || (diagram.ramp && std::isfinite(series.ramp))) return;
    if (!series.points.empty() && !hasPoints(series, diagram)) return;
    const bool known = std::ranges::any_of(entries, [&](const LegendEntry& entry) {
      return entry.name == series.name && isSameStyle(entry.style, styles[i]);
    });
    if (!known) entries.push_back({series.name.text, styles[i], true});
  };
  for (const bool theory : {false, true})
    for (std::size_t i = 0; i < diagram.series.size(); ++i)
      if (diagram.series[i].isTheory == theory) add(i);
  return entries;
}

float rampWidth(const DiagramRamp& ramp, float size) {
  const float ends = textWidth(ramp.from.text, size) + textWidth(ramp.to.text, size);
  return std::max(textWidth(ramp.title.text, size), ends + (kRampLength + 2 * kEntryGap) * size);
}

float rampHeight(const DiagramRamp& ramp, float size) {
  return (ramp.title.empty() ? 1 : 2) * kRow * size;
}

float entryWidth(const LegendEntry& entry, float size) {
  return textWidth(entry.name, size) + (entry.hasSample ? (kSampleWidth + kEntryGap) * size : 0);
}

/// Sets the size of the legend around entries of this size.
void enclose(Legend& legend, float width, std::size_t rows) {
  legend.height = static_cast<float>(rows) * kRow * legend.size;
  if (legend.ramp) {
    width = std::max(width, rampWidth(*legend.ramp, legend.size));
    legend.height += rampHeight(*legend.ramp, legend.size);
  }
  legend.width = std::ceil(width + 2 * kPad * legend.size);
  legend.height = std::ceil(legend.height + 1.2F * kPad * legend.size);
}

std::size_t legendRows(const Legend& legend) {
  const auto columns = static_cast<std::size_t>(legend.columns);
  return (legend.entries.size() + columns - 1) / columns;
}

/// Returns the widths of the columns, each that of its widest entry.
std::vector<float> columnWidths(const Legend& legend) {
  const std::size_t rows = legendRows(legend);
  std::vector<float> widths;
  for (std::size_t i = 0; i < legend.entries.size(); ++i) {
    if (i % rows == 0) widths.push_back((kSampleWidth + kEntryGap) * legend.size);
    widths.back() = std::max(widths.back(), entryWidth(legend.entries[i], legend.size));
  }
  return widths;
}

/// Measures the entries column by column.
void measure(Legend& legend) {
  const std::size_t rows = legendRows(legend);
  const std::vector<float> widths = columnWidths(legend);
  const float between = kBetween * legend.size;
  float x = 0;
  for (std::size_t i = 0; i < legend.entries.size(); ++i) {
    if (i > 0 && i % rows == 0) x += widths[i / rows - 1] + between;
    legend.entries[i].origin = {x, static_cast<float>(i % rows) * kRow * legend.size};
  }
  enclose(legend, widths.empty() ? 0 : x + widths.back(), rows);
}

/// Cuts the longest names, so that all columns fit this width.
void shortenNames(Legend& legend, float width) {
  std::vector<float> widths = columnWidths(legend);
  const auto gaps = static_cast<float>(widths.empty() ? 0 : widths.size() - 1);
  float available = width - 2 * kPad * legend.size - gaps * kBetween * legend.size;
  // Columns that need less than an equal share leave the rest of it to the others.
  std::ranges::sort(widths);
  auto others = static_cast<float>(widths.size());
  float most = 0;
  for (const float needed : widths) {
    most = available / others;
    if (needed > most) break;
    available -= needed;
    --others;
  }
  for (LegendEntry& entry : legend.entries) {
    if (!entry.hasSample || entryWidth(entry, legend.size) <= most) continue;
    entry.name =
        elided(entry.name, legend.size, false, most - (kSampleWidth + kEntryGap) * legend.size);
    legend.isWhole = false;
  }
}

/// Keeps as many entries as fit the height, and counts the missing ones.
void dropEntries(Legend& legend, float height) {
  const float available = height - 1.2F * kPad * legend.size -
                          (legend.ramp ? rampHeight(*legend.ramp, legend.size) : 0);
  const auto rows = static_cast<std::size_t>(std::max(0.0F, available / (kRow * legend.size)));
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

void addSample(DrawLayer& lines, DrawLayer& marks, const LegendEntry& entry, DrawPoint left,
               float size) {
  if (!entry.hasSample) return;
  const SeriesStyle& style = entry.style;
  const float length = kSampleWidth * size, y = left.y;
  if (style.isBand)
    addRectangle(lines, {left.x, y - 0.36F * size, length, 0.72F * size},
                 withAlpha(style.colour, kBandOpacity));
  const DrawPoint middle{left.x + length / 2, y};
  if (style.hasBars)
    addLine(lines, {{middle.x, y - 0.5F * size}, {middle.x, y + 0.5F * size}}, 0.6F * style.width,
            style.colour);
  const float inset = style.width / 2;  // round ends
  addStroke(lines, {{left.x + inset, y}, {left.x + length - inset, y}}, style);
  addMark(marks, style.mark, middle, std::min(style.markSize, 0.75F * size), style.colour);
}

/// Adds a title, then the colours between the names of their ends.
void addRamp(DrawList& list, DrawLayer& layer, const DiagramRamp& ramp, DrawPoint at, float width,
             float size, const Theme& theme) {
  if (!ramp.title.empty()) {
    addLabel(list, elided(ramp.title.text, size, false, width),
             {at.x, std::round(at.y + 1.1F * size)}, size, TextAnchor::Left, theme.text);
    at.y += kRow * size;
  }
  const float baseline = std::round(at.y + 1.1F * size);
  addLabel(list, ramp.from.text, {at.x, baseline}, size, TextAnchor::Left, theme.text);
  const float left = at.x + textWidth(ramp.from.text, size) + kEntryGap * size;
  const float bar = kRampLength * size,
              top = baseline - kMiddleOfText * size - kRampHeight * size / 2;
  for (int i = 0; i < kBarSteps; ++i) {  // each reaches the right end, so that there are no gaps
    const float done = bar * static_cast<float>(i) / kBarSteps;
    addRectangle(layer, {left + done, top, bar - done, kRampHeight * size},
                 rampColour((i + 0.5) / kBarSteps, theme));
  }
  addLabel(list, ramp.to.text, {left + bar + kEntryGap * size, baseline}, size, TextAnchor::Left,
           theme.text);
}

}  // namespace

Legend legendFor(const Diagram& diagram, const std::vector<SeriesStyle>& styles, float size,
                 float width, float height) {
  Legend legend;
  legend.entries = legendEntries(diagram, styles);
  legend.ramp = diagram.ramp;
  legend.size = size;
  if (legend.empty()) return legend;
  measure(legend);
  // More columns are used where there are too many rows and the width allows it.
  while (legend.height > height && legend.columns < 4) {
    Legend wider = legend;
    ++wider.columns;
    measure(wider);
    if (wider.width > width) break;
    legend = wider;
  }
  dropEntries(legend, height);
  measure(legend);
  if (legend.width > width) shortenNames(legend, width);
  if (legend.ramp && rampWidth(*legend.ramp, size) + 2 * kPad * size > width) {
    legend.ramp.reset();
    legend.isWhole = false;
  }
  measure(legend);
  return legend;
}

Legend legendOver(const Diagram& diagram, const std::vector<SeriesStyle>& styles, float size,
                  float width) {
  Legend legend;
  legend.entries = legendEntries(diagram, styles);
  legend.ramp = diagram.ramp;
  legend.size = size;
  const float available = width - 2 * kPad * size;
  float x = 0, widest = 0;
  std::size_t row = 0;
  for (LegendEntry& entry : legend.entries) {
    const float needed = entryWidth(entry, size);
    if (x > 0 && x + needed > available) {
      x = 0;
      ++row;
    }
    entry.origin = {x, static_cast<float>(row) * kRow * size};
    widest = std::max(widest, x + needed);
    x += needed + kBetween * size;
  }
  enclose(legend, widest, legend.entries.empty() ? 0 : row + 1);
  legend.isWhole = legend.width <= width;
  return legend;
}

void addLegend(DrawList& list, const Legend& legend, const Box& box, bool framed,
               const DiagramSizes& sizes, const Theme& theme) {
  DrawLayer plate, lines, marks;
  const float size = legend.size, pad = kPad * size;
  if (framed) {
    addRectangle(plate, box, withAlpha(theme.background, 0.86F));
    addOutline(plate, box, std::max(1.0F, 0.8F * sizes.unit), withAlpha(theme.axis, 0.45F));
  }
  float top = box.y + 0.6F * pad;
  if (legend.ramp) {
    addRamp(list, lines, *legend.ramp, {box.x + pad, top}, box.width - 2 * pad, size, theme);
    top += rampHeight(*legend.ramp, size);
  }
  for (const LegendEntry& entry : legend.entries) {
    const float x = box.x + pad + entry.origin.x;
    const float baseline = std::round(top + entry.origin.y + 1.1F * size);
    addSample(lines, marks, entry, {x, baseline - kMiddleOfText * size}, size);
    const float left = x + (entry.hasSample ? (kSampleWidth + kEntryGap) * size : 0);
    addLabel(list, entry.name, {left, baseline}, size, TextAnchor::Left,
             entry.hasSample ? theme.text : theme.faintText);
  }
  for (DrawLayer* layer : {&plate, &lines, &marks})
    if (!layer->lines.empty() || !layer->triangles.empty())
      list.layers.push_back(std::move(*layer));
}

}  // namespace asperity
