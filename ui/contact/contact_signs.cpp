#include "ui/contact/contact_signs.h"

#include <algorithm>
#include <utility>

#include "ui/contact/contact_parts.h"
#include "ui/draw/fonts.h"

namespace asperity {
namespace {

constexpr float kAboveBaseline = 1.0F,
                kBelowBaseline = 0.4F;  // of a font's size: a line around its baseline

/// Returns the box of a line of text.
Box lineAt(float left, float baseline, float width, float size) {
  return {left, baseline - kAboveBaseline * size, width, (kAboveBaseline + kBelowBaseline) * size};
}

/// Adds the legend of the colours: its title, its bar and the numbers below or beside it.
void addLegendSign(std::vector<ContactSign>& signs, const ContactLayout& layout) {
  const LegendLayout& legend = layout.legend;
  const std::string_view id = explanationId(layout.scale.overlay);
  const bool hasBar = legend.bar.width > 0;
  if (id.empty() || (!hasBar && legend.title.empty())) return;
  const float size = layout.sizes.small;
  Box box = lineAt(legend.titleEnd.x - textWidth(legend.title, size), legend.titleEnd.y,
                   textWidth(legend.title, size), size);
  if (hasBar) {
    const float numbers = legend.inLine ? 5 * size : 0;  // beside the end of the bar
    const float left = legend.title.empty() ? legend.bar.x : box.x;
    const float bottom = legend.bar.bottom() + (legend.inLine ? 0 : 1.5F * size);
    const float top = legend.title.empty() ? legend.bar.y : std::min(box.y, legend.bar.y);
    box = {left, top, legend.bar.right() + numbers - left, std::max(bottom, box.bottom()) - top};
  }
  const std::string name = hasBar || legend.title.empty() ? layout.scale.title() : legend.title;
  signs.push_back({box, name, id});
}

void addAxisSigns(std::vector<ContactSign>& signs, const ContactLayout& layout) {
  if (!layout.axisTitles) return;
  const float size = layout.sizes.small;
  const std::string x = xAxisTitle(layout), height = heightAxisTitle(layout);
  const float width = textWidth(x, size), length = textWidth(height, size);
  signs.push_back({lineAt(layout.axisTitle.x - width / 2, layout.axisTitle.y, width, size), x,
                   "position along the line"});
  const float middle = layout.plot.y + layout.plot.height / 2;
  signs.push_back({{0, middle - length / 2, 1.5F * size + kBelowBaseline * size, length},
                   height,
                   "height above the surface"});
}

void addFooterSigns(std::vector<ContactSign>& signs, const ContactLayout& layout,
                    const Notes& notes) {
  if (!(layout.footer > 0)) return;
  const float size = layout.sizes.small;
  float x = layout.plot.x;
  for (const FooterNote& note : shownNotes(layout, notes)) {
    const float width = textWidth(note.text, size);
    signs.push_back({lineAt(x, layout.footer, width, size), note.text, note.id});
    x += width + textWidth(kNoteGap, size);
  }
}

}  // namespace

std::vector<ContactSign> contactSigns(const Frame& frame, const ContactPictureOptions& asked) {
  PreparedPicture prepared = prepareContact(frame, asked);
  std::vector<ContactSign> signs = contactReadings(frame, prepared.options);
  prepared.list.layers.emplace_back();  // in place of the bodies
  std::vector<HandlePosition> labels;
  const Notes notes = addLabels(prepared.list, frame, prepared.layout, &labels);
  for (HandlePosition& label : labels)
    if (!label.id.empty()) signs.push_back({label.box, std::move(label.name), label.id});
  addAxisSigns(signs, prepared.layout);
  addLegendSign(signs, prepared.layout);
  addFooterSigns(signs, prepared.layout, notes);
  return signs;
}

std::optional<ContactSign> contactSignAt(const Frame& frame, const ContactPictureOptions& options,
                                         float x, float y) {
  for (ContactSign& sign : contactSigns(frame, options))
    if (sign.box.contains(x, y)) return std::move(sign);
  return std::nullopt;
}

}  // namespace asperity
