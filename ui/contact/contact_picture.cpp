#include "ui/contact/contact_picture.h"

#include <algorithm>

#include "ui/contact/contact_parts.h"

namespace asperity {
namespace {

ContactPictureOptions tidy(ContactPictureOptions options) {
  options.width = std::max(options.width, 1);
  options.height = std::max(options.height, 1);
  return options;
}

float headerInto(DrawList& list, const Frame& frame, const ContactPictureOptions& options) {
  list.width = options.width;
  list.height = options.height;
  list.background = options.theme.background;
  return options.title ? addHeader(list, frame, options) : 0;
}

}  // namespace

Clip contactPlotArea(const Frame& frame, const ContactPictureOptions& asked) {
  const ContactPictureOptions options = tidy(asked);
  DrawList list;
  const Box plot = layoutContact(frame, options, headerInto(list, frame, options)).plot;
  return {plot.x, plot.y, plot.width, plot.height};
}

float contactUnit(const ContactPictureOptions& options) {
  return sizesFor(tidy(options)).unit;
}

DrawList composeContact(const Frame& frame, const ContactPictureOptions& asked) {
  const ContactPictureOptions options = tidy(asked);
  DrawList list;
  const ContactLayout layout = layoutContact(frame, options, headerInto(list, frame, options));
  addBodies(list, frame, layout);
  addAxes(list, layout, addLabels(list, frame, layout));
  Box taken;
  if (options.magnifier) {
    addMagnifier(list, frame, *options.magnifier, layout);
    taken = magnifierBox(frame, *options.magnifier, layout);
  }
  if (options.probe) addProbe(list, frame, *options.probe, layout, taken);
  return list;
}

}  // namespace asperity
