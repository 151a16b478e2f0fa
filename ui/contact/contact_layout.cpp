#include "ui/contact/contact_layout.h"

#include <algorithm>
#include <cmath>

#include "ui/contact/frame_curves.h"
#include "ui/draw/fonts.h"
#include "ui/draw/ticks.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

constexpr float kLowest = 50;        // minimum height in units of a plot with a legend
constexpr float kFarOutside = 1e5F;  // pixels; keeps coordinates small enough for floats
constexpr float kNarrow = 4;         // units; a contact less wide than this is marked by a dot
constexpr float kTitleGap = 10;      // units, from the legend's title to the bar

/// Adds the unit to the last number, "20 mm", because the axis has no title.
void nameUnit(AxisTicks& axis) {
  if (!axis.ticks.empty() && !axis.unit.empty()) axis.ticks.back().label += " " + axis.unit;
}

/// Leaves out x-ticks that the unit of the last one would touch.
void dropTicksUnderLast(ContactLayout& layout) {
  std::vector<Tick>& ticks = layout.xTicks.ticks;
  const float size = layout.sizes.small;
  const auto half = [&](const Tick& tick) { return textWidth(tick.label, size) / 2; };
  while (ticks.size() > 1) {
    const Tick& last = ticks.back();
    const float centre =
        std::min(layout.px(last.value), static_cast<float>(layout.width) - half(last) - 2);
    const Tick& before = ticks[ticks.size() - 2];
    if (layout.px(before.value) + half(before) + 0.6F * size < centre - half(last)) return;
    ticks.erase(ticks.end() - 2);
  }
}

/// Pixels of a row for the legend in one line: with this title, and its bar.
struct LineNeeds {
  float width = 0, bar = 0;
};

LineNeeds lineNeeds(const ContactLayout& layout, const std::string& title) {
  const Sizes& s = layout.sizes;
  const float wide = title.empty() ? 0 : textWidth(title, s.small) + kTitleGap * s.unit;
  if (!layout.scale.isShown()) return {wide, 0};
  const std::vector<ColourTick> ends = layout.scale.ticks(2, title.empty());
  const float numbers = textWidth(ends.front().label, s.small) +
                        textWidth(ends.back().label, s.small) + 2 * kNumberGap * s.unit;
  const float bar =
      std::round(std::clamp(static_cast<float>(layout.width) * 0.12F, 60 * s.unit, 150 * s.unit));
  return {wide + numbers + bar, bar};
}

/// Places the legend at the right end of the axis title's line; returns false where it would touch
/// the title.
bool placeLegend(ContactLayout& layout, const std::string& title, float from) {
  const Sizes& s = layout.sizes;
  const LineNeeds needs = lineNeeds(layout, title);
  const float right = layout.plot.right(), baseline = layout.axisTitle.y;
  if (needs.width > right - from) return false;
  layout.legend.title = title;
  layout.legend.titleEnd = {right, baseline};
  if (!layout.scale.isShown()) return true;
  const float last = textWidth(layout.scale.ticks(2, title.empty()).back().label, s.small);
  const float height = std::round(10 * s.unit);
  layout.legend.bar = {std::round(right - last - kNumberGap * s.unit - needs.bar),
                       std::round(baseline - s.small * kMiddleOfText - height / 2), needs.bar,
                       height};
  layout.legend.titleEnd.x = right - needs.width + textWidth(title, s.small);
  return true;
}

/// Arranges everything of a low picture in one line: exaggeration on the left, the axis' title, the
/// legend on the right. The title of the legend is shortened where necessary, so that the
/// exaggeration fits; then the title of the axis is moved.
void placeInLine(ContactLayout& layout, const std::string& reason) {
  const Sizes& s = layout.sizes;
  const float gap = 16 * s.unit;
  const Box& plot = layout.plot;
  const float axis = layout.axisTitles ? textWidth(xAxisTitle(layout), s.small) : 0;
  std::vector<std::string> titles;
  if (layout.scale.isShown())
    titles = {layout.scale.title(), layout.scale.shortTitle(), std::string()};
  else if (!reason.empty())
    titles = {reason};
  layout.legend.inLine = true;
  for (const bool isNamed : {true, false})
    for (const float middle : {layout.axisTitle.x, plot.x + axis / 2})
      for (const std::string& title : titles) {
        if (!layout.legend.title.empty() || layout.legend.bar.width > 0) break;
        if (title.empty() == isNamed) continue;
        if (placeLegend(layout, title, middle + axis / 2 + (axis > 0 ? gap : 0)))
          layout.axisTitle.x = middle;
      }
  const float available = layout.axisTitle.x - axis / 2 - plot.x - gap;
  if (textWidth(exaggerationText(layout), s.small) > available) return;
  layout.footer = layout.axisTitle.y;
  layout.footerWidth = available;
}

}  // namespace

std::string xAxisTitle(const ContactLayout& layout) {
  return Words::tr("position") + " (" + layout.xTicks.unit + ")";
}

Sizes sizesFor(const ContactPictureOptions& options) {
  const float scale = options.scale > 0 ? options.scale : 1;
  const float available = std::min(static_cast<float>(options.width) / (1280 * scale),
                                   static_cast<float>(options.height) / (720 * scale));
  const float unit = options.fontSize > 0 ? options.fontSize / 12 : scale * textScale(available);
  const auto font = [&](float size) { return std::max(kSmallestFont, std::round(size * unit)); };
  const float curve = options.lineWidth > 0 ? options.lineWidth : 1.7F * unit;
  return {unit, font(19), font(14), font(12), curve};
}

float Sizes::labelHeight() const {
  return std::round(1.75F * (small + 1));
}

double ContactLayout::pixelsPerMetreX() const {
  return plot.width / view.width;
}

double ContactLayout::pixelsPerMetreY() const {
  return plot.height / (view.top - view.bottom);
}

float ContactLayout::px(double x) const {
  const double pixels = plot.x + (x - view.left) * pixelsPerMetreX();
  return static_cast<float>(std::clamp<double>(pixels, -kFarOutside, kFarOutside));
}

float ContactLayout::py(double metres) const {
  const double pixels = plot.y + (view.top - metres) * pixelsPerMetreY();
  return static_cast<float>(std::clamp<double>(pixels, -kFarOutside, kFarOutside));
}

std::optional<float> ContactLayout::lastPlace(std::string_view id) const {
  const auto last = std::ranges::find(lastLabels, id, &LabelPlace::id);
  return last == lastLabels.end() ? std::nullopt : std::optional(last->left);
}

std::string exaggerationText(const ContactLayout& layout) {
  constexpr double kRounding = 0.05;  // a picture of whole pixels is to scale up to this part
  const double ratio = layout.pixelsPerMetreY() / layout.pixelsPerMetreX();
  if (std::isfinite(ratio) && std::abs(ratio - 1) <= kRounding) return Words::tr("to scale");
  if (std::isfinite(ratio) && ratio < 1)
    return filled(Words::tr("heights reduced %1\u00D7"), {shortNumber(ratio, 2)});
  return filled(Words::tr("vertical exaggeration %1\u00D7"), {shortNumber(ratio, 2)});
}

namespace {

float padding(const ContactLayout& layout) {
  return std::round(10 * layout.sizes.unit);
}

/// The legend as it fits the footer of a high picture.
struct FooterLegend {
  std::string title;  // of the colours, or the reason why there are none
  float titleWidth = 0, barWidth = 0;
  bool hasTitle = false;    // the title fits beside the bar
  bool isInOneRow = false;  // the exaggeration fits beside both
};

FooterLegend footerLegend(const ContactLayout& layout, const std::string& reason) {
  const Sizes& s = layout.sizes;
  const float u = s.unit, pad = padding(layout), width = static_cast<float>(layout.width);
  FooterLegend legend;
  legend.title = layout.scale.isShown() ? layout.scale.title() : reason;
  legend.titleWidth = textWidth(legend.title, s.small);
  // Decades need more space for their numbers than equal steps do.
  const bool isPower = layout.scale.overlay == ContactOverlay::Power;
  legend.barWidth = std::round(isPower ? std::clamp(width * 0.26F, 150 * u, 360 * u)
                                       : std::clamp(width * 0.2F, 110 * u, 300 * u));
  const float heightAxis = s.small * 4.5F;  // its title and usual numbers
  const float exaggeration = textWidth(exaggerationText(layout) + "0000", s.small);
  legend.hasTitle = legend.titleWidth + legend.barWidth + 4 * pad < width;
  legend.isInOneRow =
      heightAxis + exaggeration + legend.titleWidth + legend.barWidth + 5 * pad < width;
  return legend;
}

/// Places the plot, whose left edge the labels of the height axis determine, and the axes.
void placePlot(ContactLayout& layout, float top, float bottom, float plotLeft) {
  const Sizes& s = layout.sizes;
  const float u = s.unit, pad = padding(layout), width = static_cast<float>(layout.width);
  layout.plot.y = top;
  layout.plot.height = std::max(1.0F, bottom - top);
  layout.heightTicks =
      yTicks(layout.view.bottom, layout.view.top, layout.plot.height, 48 * u, s.small, "m");
  if (!layout.axisTitles) nameUnit(layout.heightTicks);
  const float left = widestLabel(layout.heightTicks.ticks, s.small) + 9 * u + pad +
                     (layout.axisTitles ? s.small * 1.6F : 0);
  layout.plot.x = std::round(std::max(left, plotLeft));
  layout.plot.width = std::max(1.0F, std::round(width - 2 * pad) - layout.plot.x);
  layout.xTicks = sparseTicks(layout.view.left, layout.view.left + layout.view.width,
                              layout.plot.width, s.small, "m");
  if (!layout.axisTitles) {
    nameUnit(layout.xTicks);
    dropTicksUnderLast(layout);
  }
  const float ticks = std::round(layout.plot.bottom() + 8 * u + s.small * 0.9F);
  layout.axisTitle = {layout.plot.x + layout.plot.width / 2, std::round(ticks + s.small * 1.45F)};
}

/// Places the legend and the exaggeration below the axis.
void placeFooter(ContactLayout& layout, const FooterLegend& legend) {
  const Sizes& s = layout.sizes;
  const float u = s.unit, pad = padding(layout), width = static_cast<float>(layout.width);
  const float bar = std::round(10 * u);
  const float top = std::round(static_cast<float>(layout.height) - s.small * 1.6F - bar - 3 * u);
  const float middle = std::round(top + bar / 2 + s.small * kMiddleOfText);
  if (legend.hasTitle && layout.scale.isShown()) {
    layout.legend.bar = {std::round(width - 2 * pad - legend.barWidth), top, legend.barWidth, bar};
    layout.legend.titleEnd = {layout.legend.bar.x - kTitleGap * u, middle};
  } else {
    layout.legend.titleEnd = {layout.plot.right(), middle};
  }
  if (legend.hasTitle) layout.legend.title = legend.title;
  layout.footer = legend.isInOneRow ? middle : std::round(top - s.small * 0.8F);
  const float footerEnd = legend.isInOneRow && !layout.legend.title.empty()
                              ? layout.legend.titleEnd.x - legend.titleWidth - 3 * pad
                              : width - 2 * pad;
  layout.footerWidth = std::max(0.0F, footerEnd - layout.plot.x);
}

}  // namespace

ContactLayout layoutContact(const Frame& frame, const ContactPictureOptions& options,
                            float headerBottom) {
  ContactLayout layout;
  layout.width = options.width;
  layout.height = options.height;
  layout.sizes = sizesFor(options);
  layout.theme = options.theme;
  layout.lastLabels = options.lastLabels;
  layout.view = resolvedView(frame, options.view);
  layout.scale = {options.overlay, colourMaximum(layout.view, options.overlay)};
  if (overlayValues(frame, options.overlay).size() != frame.lineHeight.size())
    layout.scale = {};  // the frame lacks the values
  const std::string reason = layout.scale.isShown() ? "" : reasonUncoloured(frame, options.overlay);
  const bool hasLegend = layout.scale.isShown() || !reason.empty();
  const Sizes& s = layout.sizes;
  const float u = s.unit;

  const float pad = padding(layout);
  const float tickRow = std::round(8 * u + s.small);
  const float titleRow = std::round(s.small * 1.5F);
  const float footerRow = std::round(s.small * 2.9F);
  const float available = static_cast<float>(options.height) - headerBottom - pad;
  layout.axisTitles = available - tickRow > 90 * u;
  const bool hasFooter = available - tickRow - titleRow - footerRow > 150 * u;
  const bool hasLine =
      layout.axisTitles || (hasLegend && available - tickRow - titleRow > kLowest * u);
  const FooterLegend legend = footerLegend(layout, reason);
  float below = tickRow + pad * 0.6F;
  if (hasLine) below += titleRow;
  if (hasFooter) below += legend.isInOneRow ? footerRow : footerRow + titleRow;
  const float top = std::round(headerBottom + pad);
  placePlot(layout, top, std::round(static_cast<float>(options.height) - below), options.plotLeft);
  layout.marked = narrowContact(frame, kNarrow * u / layout.pixelsPerMetreX());
  if (hasFooter)
    placeFooter(layout, legend);
  else if (hasLine)
    placeInLine(layout, reason);
  return layout;
}

}  // namespace asperity
