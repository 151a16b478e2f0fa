#include "ui/contact/contact_signs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/scene/parameters.h"
#include "ui/contact/contact_parts.h"
#include "ui/contact/contact_probe.h"
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

/// The labels in the plot and the notes of the footer.
struct Labels {
  std::vector<ContactSign> signs;
  Notes notes;
};

Labels makeLabels(PreparedPicture& prepared, const Frame& frame) {
  prepared.list.layers.emplace_back();  // in place of the bodies
  Labels labels;
  labels.notes = addLabels(prepared.list, frame, prepared.layout, labels.signs);
  return labels;
}

}  // namespace

std::vector<ContactSign> contactSigns(const Frame& frame, const ContactPictureOptions& requested) {
  PreparedPicture prepared = prepareContact(frame, requested);
  std::vector<ContactSign> signs = contactReadings(frame, prepared.options);
  Labels labels = makeLabels(prepared, frame);
  for (ContactSign& label : labels.signs)
    if (!label.id.empty()) signs.push_back(std::move(label));
  addAxisSigns(signs, prepared.layout);
  addLegendSign(signs, prepared.layout);
  addFooterSigns(signs, prepared.layout, labels.notes);
  return signs;
}

std::optional<ContactSign> contactSignAt(const Frame& frame, const ContactPictureOptions& options,
                                         float x, float y) {
  for (ContactSign& sign : contactSigns(frame, options))
    if (sign.box.contains(x, y)) return std::move(sign);
  return std::nullopt;
}

// ---- Handles

namespace {

constexpr double kDecadesDown = 2, kDecadesAcross = 4;

double withFourDigits(double value) {
  return std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr);
}

}  // namespace

std::vector<ContactSign> contactHandles(const Frame& frame, const ContactPictureOptions& options) {
  PreparedPicture prepared = prepareContact(frame, options);
  std::vector<ContactSign> labels = makeLabels(prepared, frame).signs;
  std::erase_if(labels, [](const ContactSign& label) {
    return label.handle == ContactHandle::None || label.handle == ContactHandle::Body;
  });
  return labels;
}

ContactHandle handleAt(const Frame& frame, const ContactPictureOptions& requested, float x,
                       float y) {
  constexpr float kReach = 5;  // units below the line that still belong to the rigid body
  PreparedPicture prepared = prepareContact(frame, requested);
  for (const ContactSign& sign : makeLabels(prepared, frame).signs)
    if (sign.box.contains(x, y)) return sign.handle;
  const ContactPictureOptions& options = prepared.options;
  const ContactLayout& layout = prepared.layout;
  const Box& plot = layout.plot;
  if (!plot.contains(x, y)) return ContactHandle::None;
  if (options.magnifier && magnifierBox(frame, *options.magnifier, layout).contains(x, y))
    return ContactHandle::None;
  const auto reading =
      probeReading(frame, layout.view.left + (x - plot.x) / layout.pixelsPerMetreX());
  if (!reading || y > layout.py(reading->line) + kReach * layout.sizes.unit)
    return ContactHandle::None;
  return ContactHandle::Body;
}

std::string_view draggedKey(ContactHandle handle, const Scene& scene) {
  if (handle == ContactHandle::None) return {};
  if (handle == ContactHandle::Velocity)
    return scene.sliding.kind == SlidingKind::Oscillation ? "sliding.amplitude" : kVelocityKey;
  switch (scene.load.kind) {
    case LoadKind::Force:
      return "load.normal_force";
    case LoadKind::Pressure:
      return "load.nominal_pressure";
    case LoadKind::Indentation:
      break;
  }
  return handle == ContactHandle::Body ? "load.depth" : "";
}

Scene dragged(const Scene& start, ContactHandle handle, const DragDistance& moved) {
  const std::string_view key = draggedKey(handle, start);
  const double displacement = handle == ContactHandle::Velocity ? moved.right : moved.down;
  if (key.empty() || displacement == 0) return start;  // not even rounded
  const Parameter& parameter = knownParameter(key);
  const auto& field = std::get<RealField>(parameter.field);
  const double before = std::get<double>(parameterValue(parameter, start));
  double value = before;
  if (key == "load.depth") {
    // At least a thousandth of the depth remains, so that the body cannot leave the contact
    // permanently.
    value = std::max(before + moved.down * moved.height, 1e-3 * before);
  } else if (handle == ContactHandle::Velocity) {
    // A line at rest begins at the slowest velocity of the slider.
    const double from = before > 0 ? before : field.sliderFrom;
    if (before > 0 || moved.right > 0) value = from * std::pow(10, kDecadesAcross * moved.right);
  } else {
    value = before * std::pow(10, kDecadesDown * moved.down);
  }
  if (!std::isfinite(value)) return start;
  Scene after = start;
  setValue(parameter, after, std::clamp(withFourDigits(value), field.minimum, field.maximum));
  return after;
}

}  // namespace asperity
