#include <cmath>

#include "ui/contact/contact_parts.h"
#include "ui/draw/fonts.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

/// Adds a sharp line, one or more whole pixels wide.
void addRule(DrawLayer& layer, float x, float y, float width, float height, const Rgba& colour) {
  addRectangle(layer, {std::round(x), std::round(y), std::round(width), std::round(height)},
               colour);
}

void addFrame(DrawLayer& layer, const ContactLayout& layout) {
  const Box& p = layout.plot;
  const float w = std::max(1.0F, std::round(layout.sizes.unit));
  const Rgba& colour = layout.theme.axis;
  addRule(layer, p.x - w, p.y - w, p.width + 2 * w, w, colour);
  addRule(layer, p.x - w, p.bottom(), p.width + 2 * w, w, colour);
  addRule(layer, p.x - w, p.y, w, p.height, colour);
  addRule(layer, p.right(), p.y, w, p.height, colour);
}

/// Adds the x-axis. Labels near an end are pushed inwards so that they stay on the picture.
void addXAxis(DrawList& list, DrawLayer& layer, const ContactLayout& layout) {
  const Sizes& s = layout.sizes;
  const float w = std::max(1.0F, std::round(s.unit));
  const float baseline = std::round(layout.plot.bottom() + 8 * s.unit + s.small * 0.9F);
  for (const Tick& tick : layout.xTicks.ticks) {
    const float x = std::floor(layout.px(tick.value));
    addRule(layer, x, layout.plot.bottom() + w, w, 5 * s.unit, layout.theme.axis);
    const float half = textWidth(tick.label, s.small) / 2;
    const float centre = std::min(x, static_cast<float>(layout.width) - half - 2);
    addLabel(list, tick.label, {centre, baseline}, s.small, TextAnchor::Centre,
             layout.theme.faintText);
  }
  if (!layout.axisTitles) return;
  addLabel(list, xAxisTitle(layout), layout.axisTitle, s.small, TextAnchor::Centre,
           layout.theme.text);
}

void addHeightAxis(DrawList& list, DrawLayer& layer, const ContactLayout& layout) {
  const Sizes& s = layout.sizes;
  const float w = std::max(1.0F, std::round(s.unit));
  for (const Tick& tick : layout.heightTicks.ticks) {
    const float y = std::floor(layout.py(tick.value));
    addRule(layer, layout.plot.x - w - 5 * s.unit, y, 5 * s.unit, w, layout.theme.axis);
    const float baseline = std::min(y + kMiddleOfText * s.small, layout.plot.bottom());
    addLabel(list, tick.label, {layout.plot.x - 8 * s.unit, std::round(baseline)}, s.small,
             TextAnchor::Right, layout.theme.faintText);
  }
  if (!layout.axisTitles) return;
  addLabel(list, heightAxisTitle(layout),
           {std::round(s.small * 1.5F), layout.plot.y + layout.plot.height / 2}, s.small,
           TextAnchor::Centre, layout.theme.text, 1.57079633F);
}

/// Adds the numbers of both ends, on the title's line.
void addNumbersBeside(DrawList& list, const ContactLayout& layout) {
  const Sizes& s = layout.sizes;
  const Box& bar = layout.legend.bar;
  const std::vector<ColourTick> ticks = layout.scale.ticks(2, layout.legend.title.empty());
  const float gap = kNumberGap * s.unit, baseline = layout.legend.titleEnd.y;
  addLabel(list, ticks.front().label, {bar.x - gap, baseline}, s.small, TextAnchor::Right,
           layout.theme.faintText);
  addLabel(list, ticks.back().label, {bar.right() + gap, baseline}, s.small, TextAnchor::Left,
           layout.theme.faintText);
}

/// Adds the labels of both ends, within the bar or nearly so, and others where they fit.
void addLegendLabels(DrawList& list, DrawLayer& layer, const ContactLayout& layout) {
  const Sizes& s = layout.sizes;
  const Box& bar = layout.legend.bar;
  const std::vector<ColourTick> ticks = layout.scale.ticks(6, false);
  const float baseline = std::round(bar.bottom() + s.small * 1.15F);
  const float wide = std::max(1.0F, std::round(s.unit));
  const auto write = [&](const ColourTick& tick, TextAnchor anchor) {
    // Smoothed edges of digits stay within the bar.
    const float x = std::min(bar.x + tick.position * bar.width, bar.right() - 0.5F);
    addLabel(list, tick.label, {x, baseline}, s.small, anchor, layout.theme.faintText);
  };
  for (const ColourTick& tick : ticks)
    addRule(layer, std::min(bar.x + tick.position * bar.width, bar.right() - wide), bar.bottom(),
            wide, 3 * s.unit, layout.theme.axis);
  const auto half = [&](const ColourTick& tick) { return textWidth(tick.label, s.small) / 2; };
  const ColourTick &first = ticks.front(), &last = ticks.back();
  const bool isZero = first.label == "0";
  write(first, isZero ? TextAnchor::Centre : TextAnchor::Left);
  write(last, TextAnchor::Right);
  const float gap = 0.6F * s.small;
  float from = bar.x + (isZero ? 1 : 2) * half(first) + gap;
  const float to = bar.right() - 2 * half(last) - gap;
  for (std::size_t i = 1; i + 1 < ticks.size(); ++i) {
    const float x = bar.x + ticks[i].position * bar.width;
    if (x - half(ticks[i]) < from || x + half(ticks[i]) > to) continue;
    write(ticks[i], TextAnchor::Centre);
    from = x + half(ticks[i]) + gap;
  }
}

/// Adds strokes that grow like the values, as under the contacts.
void addStrokes(DrawLayer& layer, const ContactLayout& layout) {
  const Box& bar = layout.legend.bar;
  const float u = layout.sizes.unit, step = 3 * u;
  for (float x = step; x <= bar.width; x += step)
    addLine(layer, {{bar.x + x, bar.y}, {bar.x + x, bar.y + bar.height * x / bar.width}},
            std::max(1.0F, 0.9F * u), layout.theme.text);
}

void addLegend(DrawList& list, DrawLayer& layer, const ContactLayout& layout) {
  const Box& bar = layout.legend.bar;
  if (layout.theme.isPaper) {
    addStrokes(layer, layout);
    return layout.legend.inLine ? addNumbersBeside(list, layout)
                                : addLegendLabels(list, layer, layout);
  }
  constexpr int kSteps = 20;  // twice the number of control colours of the maps, or more
  const float step = bar.width / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const Box part{bar.x + static_cast<float>(i) * step, bar.y, step, bar.height};
    addRectangleAcross(layer, part, layout.scale.colourAt(static_cast<float>(i) / kSteps),
                       layout.scale.colourAt(static_cast<float>(i + 1) / kSteps));
  }
  layout.legend.inLine ? addNumbersBeside(list, layout) : addLegendLabels(list, layer, layout);
}

void addFooter(DrawList& list, const ContactLayout& layout, const Notes& notes) {
  std::string footer;
  for (const FooterNote& note : shownNotes(layout, notes))
    footer += footer.empty() ? note.text : kNoteGap + note.text;
  addLabel(list, footer, {layout.plot.x, layout.footer}, layout.sizes.small, TextAnchor::Left,
           layout.theme.faintText);
}

}  // namespace

std::string heightAxisTitle(const ContactLayout& layout) {
  const std::string unit = " (" + layout.heightTicks.unit + ")";
  const std::string title = Words::tr("height above the undeformed surface") + unit;
  return textWidth(title, layout.sizes.small) > layout.plot.height ? Words::tr("height") + unit
                                                                   : title;
}

Notes shownNotes(const ContactLayout& layout, const Notes& notes) {
  Notes shown;
  std::string footer;
  for (const FooterNote& note : notes) {
    const std::string longer = footer.empty() ? note.text : footer + kNoteGap + note.text;
    if (!footer.empty() && textWidth(longer, layout.sizes.small) > layout.footerWidth) continue;
    footer = longer;
    shown.push_back(note);
  }
  return shown;
}

void addAxes(DrawList& list, const ContactLayout& layout, const Notes& notes) {
  DrawLayer layer;
  addFrame(layer, layout);
  addXAxis(list, layer, layout);
  addHeightAxis(list, layer, layout);
  if (layout.legend.bar.width > 0) addLegend(list, layer, layout);
  if (!layout.legend.title.empty())
    addLabel(list, layout.legend.title, layout.legend.titleEnd, layout.sizes.small,
             TextAnchor::Right, layout.theme.text);
  if (layout.footer > 0) addFooter(list, layout, notes);
  list.layers.push_back(std::move(layer));
}

}  // namespace asperity
