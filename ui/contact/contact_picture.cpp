#include "ui/contact/contact_picture.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "ui/contact/contact_handles.h"
#include "ui/contact/contact_parts.h"
#include "ui/contact/contact_probe.h"

namespace asperity {
namespace {

ContactPictureOptions tidy(ContactPictureOptions options) {
  options.width = std::max(options.width, 1);
  options.height = std::max(options.height, 1);
  return options;
}

}  // namespace

PreparedPicture prepareContact(const Frame& frame, const ContactPictureOptions& asked) {
  PreparedPicture prepared{tidy(asked), {}, {}};
  const ContactPictureOptions& options = prepared.options;
  prepared.list.width = options.width;
  prepared.list.height = options.height;
  prepared.list.background = options.theme.background;
  const float header = options.title ? addHeader(prepared.list, frame, options) : 0;
  prepared.layout = layoutContact(frame, options, header);
  return prepared;
}

Box contactPlotArea(const Frame& frame, const ContactPictureOptions& asked) {
  return prepareContact(frame, asked).layout.plot;
}

float contactUnit(const ContactPictureOptions& options) {
  return sizesFor(tidy(options)).unit;
}

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

DrawList composeContact(const Frame& frame, const ContactPictureOptions& asked) {
  PreparedPicture prepared = prepareContact(frame, asked);
  const ContactPictureOptions& options = prepared.options;
  const ContactLayout& layout = prepared.layout;
  DrawList& list = prepared.list;
  Box taken;
  if (options.magnifier) taken = magnifierBox(frame, *options.magnifier, layout);
  prepared.layout.covered = {taken};
  if (options.probe)
    prepared.layout.covered.push_back(readoutBox(frame, *options.probe, layout, taken));
  addBodies(list, frame, layout);
  addAxes(list, layout, options.names ? addLabels(list, frame, layout) : Notes{});
  if (options.magnifier) addMagnifier(list, frame, *options.magnifier, layout);
  if (options.probe) addProbe(list, frame, *options.probe, layout, taken);
  return std::move(prepared.list);
}

}  // namespace asperity
