#include "ui/contact/contact_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/intervals.h"
#include "ui/contact/contact_overlay.h"
#include "ui/contact/contact_parts.h"
#include "ui/contact/frame_curves.h"
#include "ui/draw/ticks.h"

namespace asperity {
namespace {

ContactPictureOptions withMinimumSize(ContactPictureOptions options) {
  options.width = std::max(options.width, 1);
  options.height = std::max(options.height, 1);
  return options;
}

// Space above and below the rough interface, relative to its height range, for the bodies and their
// labels.
constexpr double kSpaceAbove = 0.24, kSpaceBelow = 0.30;
// Largest part of the plot's height above the line that labels are given, which is what they need
// in the lowest plot that has any, and a part beyond what they need, so that a line that moves up a
// little changes nothing.
constexpr double kMaxLabelSpace = 0.34, kSpareSpace = 0.03;
constexpr double kMaxPeriods = 50;

/// Returns the heights of both bodies at these points of the periodic frame, m; 0 where there are
/// none.
Extent interfaceExtent(const Frame& frame, PointRange points) {
  Extent extent;
  for (const std::vector<double>* heights : {&frame.lineHeight, &frame.surfaceHeight}) {
    const std::int64_t count = std::ssize(*heights);
    for (std::int64_t i = points.first; count > 0 && i <= points.last; ++i)
      extent.add((*heights)[static_cast<std::size_t>((i % count + count) % count)]);
  }
  return extent.isEmpty() ? Extent{0, 0} : extent;
}

Extent interfaceExtent(const Frame& frame) {
  return interfaceExtent(frame, {0, std::ssize(frame.lineHeight) - 1});
}

/// Extends the range of a flat interface to the undeformed surface, or to a micrometre around it.
Extent withMinimumHeight(Extent extent) {
  const double farthest = std::max(std::abs(extent.least), std::abs(extent.most));
  if (extent.size() > 1e-9 * farthest) return extent;
  if (farthest == 0) return {-0.5e-6, 0.5e-6};
  return {std::min(extent.least, 0.0) - 0.2 * farthest,
          std::max(extent.most, 0.0) + 0.2 * farthest};
}

/// Returns the space above the interface relative to its height range.
double spaceAbove(double labelSpace) {
  const double part = labelSpace > 0 ? labelSpace + kSpareSpace : 0;  // of the view's heights
  return std::max(kSpaceAbove, (1 + kSpaceBelow) * part / (1 - part));
}

bool stillFits(const ContactView& view, const Extent& extent, double labelSpace) {
  const double size = view.top - view.bottom;
  const double fill = extent.size() / size;
  const double usual = (1 + kSpaceAbove + kSpaceBelow) / (1 + spaceAbove(labelSpace) + kSpaceBelow);
  return size > 0 && fill > 0.48 * usual &&
         extent.most < view.top - std::max(0.10, labelSpace) * size &&
         extent.least > view.bottom + 0.09 * usual * size;
}

/// Fits the heights of the view to those of the interface. The ends are rounded outwards, so that
/// small changes do not move the axis.
void fitHeights(ContactView& view, const Extent& extent, double labelSpace) {
  const double grid = roundUp125(extent.size() / 20);
  view.bottom = std::floor((extent.least - kSpaceBelow * extent.size()) / grid) * grid;
  view.top = std::ceil((extent.most + spaceAbove(labelSpace) * extent.size()) / grid) * grid;
}

}  // namespace

ContactView fittedView(const Frame& frame, const std::optional<ContactView>& last,
                       double labelSpace) {
  ContactView view = last.value_or(ContactView{});
  const Extent extent = withMinimumHeight(interfaceExtent(frame));
  if (!stillFits(view, extent, labelSpace)) fitHeights(view, extent, labelSpace);
  view.pressure = scaleMaximum(frame, ContactOverlay::Pressure, view.pressure);
  view.age = scaleMaximum(frame, ContactOverlay::Relaxation, view.age);
  view.power = scaleMaximum(frame, ContactOverlay::Power, view.power);
  return view;
}

void fitToPart(const Frame& frame, ContactView& view) {
  if (!isDrawable(frame)) return;
  const PointRange points = pointsWithin(frame, view.left, view.width);
  if (points.count() < std::ssize(frame.lineHeight))
    fitHeights(view, withMinimumHeight(interfaceExtent(frame, points)), 0);
}

ContactView resolvedView(const Frame& frame, const ContactView& view) {
  const double period = isDrawable(frame)  ? periodLength(frame)
                        : frame.length > 0 ? frame.length
                                           : 1;
  ContactView resolved = view;
  if (!std::isfinite(resolved.left)) resolved.left = 0;
  if (!(resolved.width > 0)) resolved.width = period;
  resolved.width = std::min(resolved.width, kMaxPeriods * period);
  const ContactView fitted = fittedView(frame);
  if (!(resolved.bottom < resolved.top) || !std::isfinite(resolved.top - resolved.bottom)) {
    resolved.bottom = fitted.bottom;
    resolved.top = fitted.top;
  }
  if (!(resolved.pressure > 0)) resolved.pressure = fitted.pressure;
  if (!(resolved.age > 0)) resolved.age = fitted.age;
  if (!(resolved.power > 0)) resolved.power = fitted.power;
  return resolved;
}

PreparedPicture prepareContact(const Frame& frame, const ContactPictureOptions& requested) {
  PreparedPicture prepared{withMinimumSize(requested), {}, {}};
  const ContactPictureOptions& options = prepared.options;
  prepared.list.width = options.width;
  prepared.list.height = options.height;
  prepared.list.background = options.theme.background;
  const float header = options.title ? addHeader(prepared.list, frame, options) : 0;
  prepared.layout = layoutContact(frame, options, header);
  return prepared;
}

Box contactPlotArea(const Frame& frame, const ContactPictureOptions& requested) {
  return prepareContact(frame, requested).layout.plot;
}

double labelSpace(const Frame& frame, const ContactPictureOptions& requested) {
  const ContactLayout layout = prepareContact(frame, requested).layout;
  const double needed = labelRowBottom(layout) - layout.plot.y + 1;
  const double part = needed / layout.plot.height;
  return part < kMaxLabelSpace ? part : 0;
}

float contactUnit(const ContactPictureOptions& options) {
  return sizesFor(withMinimumSize(options)).unit;
}

DrawList composeContact(const Frame& frame, const ContactPictureOptions& requested,
                        std::vector<LabelPlace>* places) {
  PreparedPicture prepared = prepareContact(frame, requested);
  const ContactPictureOptions& options = prepared.options;
  const ContactLayout& layout = prepared.layout;
  DrawList& list = prepared.list;
  Box taken;
  if (options.magnifier) taken = magnifierBox(frame, *options.magnifier, layout);
  prepared.layout.covered = {taken};
  if (options.probe)
    prepared.layout.covered.push_back(readoutBox(frame, *options.probe, layout, taken));
  addBodies(list, frame, layout);
  std::vector<ContactSign> labels;
  addAxes(list, layout, options.names ? addLabels(list, frame, layout, labels) : Notes{});
  if (places) {
    places->clear();
    for (const ContactSign& label : labels) places->push_back({label.id, label.box.x});
  }
  if (options.magnifier) addMagnifier(list, frame, *options.magnifier, layout);
  if (options.probe) addProbe(list, frame, *options.probe, layout, taken);
  return std::move(prepared.list);
}

}  // namespace asperity
