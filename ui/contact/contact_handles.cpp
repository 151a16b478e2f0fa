#include "ui/contact/contact_handles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/scene/parameters.h"
#include "ui/contact/contact_parts.h"
#include "ui/contact/contact_probe.h"

namespace asperity {
namespace {

constexpr double kDecadesDown = 2, kDecadesAcross = 4;

double withFourDigits(double value) {
  return std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr);
}

}  // namespace

std::vector<HandlePosition> contactHandles(const Frame& frame, const ContactPictureOptions& asked) {
  PreparedPicture prepared = prepareContact(frame, asked);
  prepared.list.layers.emplace_back();  // in place of the bodies
  std::vector<HandlePosition> handles;
  addLabels(prepared.list, frame, prepared.layout, &handles);
  std::erase_if(handles, [](const HandlePosition& position) {
    return position.handle == ContactHandle::None;
  });
  return handles;
}

ContactHandle handleAt(const Frame& frame, const ContactPictureOptions& asked, float x, float y) {
  constexpr float kReach = 5;  // units below the line that still belong to the rigid body
  for (const HandlePosition& handle : contactHandles(frame, asked))
    if (handle.box.contains(x, y)) return handle.handle;
  const PreparedPicture prepared = prepareContact(frame, asked);
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
