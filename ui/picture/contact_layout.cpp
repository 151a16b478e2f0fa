#include "ui/picture/contact_layout.h"

#include <algorithm>
#include <cmath>

#include "ui/language/words.h"
#include "ui/picture/narrow_contact.h"
#include "ui/picture/plot_axes.h"
#include "ui/picture/text_metrics.h"

namespace asperity {
namespace {

constexpr float kFarOutside = 1e5F;  // pixels; keeps coordinates small enough for floats
constexpr float kNarrow = 4;         // units; a contact less wide than this is marked by a dot

int tickCount(float pixels, float each) {
  return std::clamp(static_cast<int>(pixels / each), 2, 12);
}

float widestLabel(const AxisTicks& axis, float size) {
  float widest = 0;
  for (const Tick& tick : axis.ticks) widest = std::max(widest, textWidth(tick.label, size));
  return widest;
}

}  // namespace

Sizes sizesFor(const ContactPictureOptions& options) {
  const float scale = options.scale > 0 ? options.scale : 1;
  const float room = std::min(static_cast<float>(options.width) / (1280 * scale),
                              static_cast<float>(options.height) / (720 * scale));
  // Small pictures shrink their texts a little, large ones enlarge them less than themselves.
  const float unit = scale * (room > 1 ? std::pow(room, 0.7F) : std::clamp(room, 0.85F, 1.0F));
  const auto font = [&](float size) { return std::max(7.0F, std::round(size * unit)); };
  return {unit, font(19), font(14), font(12)};
}

double ContactLayout::pixelsPerMetreAlong() const {
  return plot.width / view.width;
}

double ContactLayout::pixelsPerMetreUp() const {
  return plot.height / (view.top - view.bottom);
}

float ContactLayout::px(double x) const {
  const double pixels = plot.x + (x - view.left) * pixelsPerMetreAlong();
  return static_cast<float>(std::clamp<double>(pixels, -kFarOutside, kFarOutside));
}

float ContactLayout::py(double metres) const {
  const double pixels = plot.y + (view.top - metres) * pixelsPerMetreUp();
  return static_cast<float>(std::clamp<double>(pixels, -kFarOutside, kFarOutside));
}

std::string exaggerationText(const ContactLayout& layout) {
  const double ratio = layout.pixelsPerMetreUp() / layout.pixelsPerMetreAlong();
  return filled(Words::tr("vertical exaggeration %1\u00D7"), {shortNumber(ratio, 2)});
}

ContactLayout layoutContact(const Frame& frame, const ContactPictureOptions& options,
                            float headerBottom) {
  ContactLayout layout;
  layout.width = options.width;
  layout.height = options.height;
  layout.sizes = sizesFor(options);
  layout.theme = options.theme;
  layout.view = resolvedView(frame, options.view);
  layout.scale = {options.overlay, endIn(layout.view, options.overlay)};
  if (valuesOf(frame, options.overlay).size() != frame.lineHeight.size())
    layout.scale = {};  // the frame lacks them
  const Sizes& s = layout.sizes;
  const float u = s.unit;
  const auto width = static_cast<float>(options.width), height = static_cast<float>(options.height);

  const float pad = std::round(10 * u);
  const float tickRow = std::round(8 * u + s.small);
  const float titleRow = std::round(s.small * 1.5F);
  const float footerRow = std::round(s.small * 2.9F);
  const float room = height - headerBottom - pad;
  layout.axisTitles = room - tickRow > 90 * u;
  const bool footer = room - tickRow - titleRow - footerRow > 150 * u;

  // Sideways: the height axis' labels decide.
  const float plotTop = std::round(headerBottom + pad);
  float below = tickRow + pad * 0.6F;
  if (layout.axisTitles) below += titleRow;
  const float exaggeration = textWidth(exaggerationText(layout) + "0000", s.small);
  const float titleWidth = textWidth(layout.scale.title(), s.small);
  const float barWidth = std::round(std::clamp(width * 0.2F, 110 * u, 300 * u));
  const bool oneRow = exaggeration + titleWidth + barWidth + 5 * pad < width;
  const bool titleFits = titleWidth + barWidth + 4 * pad < width;
  if (footer) below += oneRow ? footerRow : footerRow + titleRow;
  layout.plot.y = plotTop;
  layout.plot.height = std::max(1.0F, std::round(height - below) - plotTop);
  layout.heightTicks =
      linearTicks(layout.view.bottom, layout.view.top, tickCount(layout.plot.height, 48 * u), "m");
  const float left = widestLabel(layout.heightTicks, s.small) + 9 * u + pad +
                     (layout.axisTitles ? s.small * 1.6F : 0);
  layout.plot.x = std::round(left);
  layout.plot.width = std::max(1.0F, std::round(width - 2 * pad) - layout.plot.x);
  layout.xTicks = roomyTicks(layout.view.left, layout.view.left + layout.view.width,
                             layout.plot.width, s.small, "m");
  layout.marked = narrowContact(frame, kNarrow * u / layout.pixelsPerMetreAlong());
  if (!footer) return layout;

  const float bar = std::round(10 * u);
  const float legendTop = std::round(height - s.small * 1.6F - bar - 3 * u);
  const bool hasLegend = titleFits && layout.scale.isShown();
  layout.legend = {std::round(width - 2 * pad - barWidth), legendTop, hasLegend ? barWidth : 0,
                   bar};
  layout.footer = oneRow ? std::round(legendTop + bar * 0.5F + s.small * 0.36F)
                         : std::round(legendTop - s.small * 0.8F);
  const float footerEnd =
      oneRow && hasLegend ? layout.legend.x - titleWidth - 4 * pad : width - 2 * pad;
  layout.footerWidth = std::max(0.0F, footerEnd - layout.plot.x);
  return layout;
}

}  // namespace asperity
