// The inset of a contact picture that enlarges one asperity.
#include <algorithm>
#include <cmath>

#include "ui/picture/colours.h"
#include "ui/picture/contact_insets.h"
#include "ui/picture/contact_parts.h"
#include "ui/picture/decimate.h"
#include "ui/picture/narrow_contact.h"
#include "ui/picture/text_metrics.h"

namespace asperity {
namespace {

constexpr float kLeastWidth = 110, kLeastHeight = 74;  // units
constexpr int kLeastPoints = 6;                        // of the frame in the inset

/// The part of the world in the inset. Its heights end at round places, so that they stand still
/// while a contact is followed.
ContactView partOf(const Frame& frame, const Magnifier& magnifier, const ContactLayout& layout,
                   float pixels) {
  ContactView view = layout.view;
  const double enlargement = magnifier.enlargement > 1 ? magnifier.enlargement : 1;
  view.width = std::max(pixels / layout.pixelsPerMetreAlong() / enlargement,
                        std::min(kLeastPoints * frame.spacing, view.width));
  view.left = magnifier.position - 0.5 * view.width;
  const PointRange range = pointsWithin(frame, view.left, view.width);
  const Columns columns{view.left, pixels / view.width};
  double low = 0, high = 0;
  bool isFirst = true;
  for (const std::vector<double>* heights : {&frame.lineHeight, &frame.surfaceHeight})
    for (const CurveVertex& v : decimated(frame, *heights, range, columns)) {
      if (!std::isfinite(v.height)) continue;
      low = isFirst ? v.height : std::min(low, v.height);
      high = isFirst ? v.height : std::max(high, v.height);
      isFirst = false;
    }
  const double least = 1e-3 * (layout.view.top - layout.view.bottom);
  const double size = roundUp(1.6 * std::max(high - low, least));
  const double grid = size / 20;
  view.bottom = std::round((0.5 * (low + high) - 0.55 * size) / grid) * grid;
  view.top = view.bottom + size;
  return view;
}

/// What is enlarged, in the picture around: at least a few pixels wide.
Box sourceBox(const ContactView& part, const ContactLayout& layout) {
  const Box& plot = layout.plot;
  const float left = std::max(layout.px(part.left), plot.x);
  const float right = std::min(layout.px(part.left + part.width), plot.right());
  const float top = std::clamp(layout.py(part.top), plot.y, plot.bottom());
  const float bottom = std::clamp(layout.py(part.bottom), plot.y, plot.bottom());
  const float least = 6 * layout.sizes.unit;
  const float width = std::max(right - left, least), height = std::max(bottom - top, least);
  return {0.5F * (left + right - width), 0.5F * (top + bottom - height), width, height};
}

void addBorder(DrawLayer& layer, const Box& b, float width, const Rgba& colour) {
  addLine(layer,
          {{b.x, b.y}, {b.right(), b.y}, {b.right(), b.bottom()}, {b.x, b.bottom()}, {b.x, b.y}},
          width, colour);
}

/// From the enlarged part to the inset's near corners.
void addConnection(DrawLayer& layer, const Box& source, const Box& inset, float width,
                   const Rgba& colour) {
  const bool insetIsRight = inset.x > source.x;
  const float from = insetIsRight ? source.right() : source.x;
  const float to = insetIsRight ? inset.x : inset.right();
  addLine(layer, {{from, source.y}, {to, inset.y}}, width, colour);
  addLine(layer, {{from, source.bottom()}, {to, inset.bottom()}}, width, colour);
}

/// Round, and 0.12 to 0.3 of the whole.
double barLength(double whole) {
  return roundUp125(0.12 * whole);
}

/// Two bars from the lower left corner with their lengths, on a plate; what they say of the scale.
void addScaleBars(DrawList& list, DrawLayer& layer, const ContactLayout& inset) {
  const Sizes& s = inset.sizes;
  const float u = s.unit, edge = std::round(9 * u);
  const double along = barLength(inset.view.width);
  const double up = barLength(inset.view.top - inset.view.bottom);
  const auto width = static_cast<float>(along * inset.pixelsPerMetreAlong());
  const auto height = static_cast<float>(up * inset.pixelsPerMetreUp());
  const std::string alongText = quantity(along, "m"), upText = quantity(up, "m");
  const Place corner{inset.plot.x + edge, inset.plot.bottom() - edge};
  const Rgba ink = textOn(inset.theme.elastomer);
  const float texts =
      std::max(textWidth(upText, s.small), width + 5 * u + textWidth(alongText, s.small));
  const float above = height + 5 * u + s.small;
  addRectangle(layer, {corner.x - 5 * u, corner.y - above - 3 * u, texts + 10 * u, above + 8 * u},
               withAlpha(mix(inset.theme.elastomer, {0, 0, 0, 1}, 0.3F), 0.75F));
  addLine(layer, {{corner.x, corner.y - height}, corner, {corner.x + width, corner.y}}, 2 * u, ink);
  addLabel(list, upText, {corner.x - 2 * u, std::round(corner.y - height - 5 * u)}, s.small,
           TextAnchor::Left, ink);
  addLabel(list, alongText, {corner.x + width + 5 * u, std::round(corner.y + 0.2F * s.small)},
           s.small, TextAnchor::Left, ink);
}

void addHeading(DrawList& list, const ContactLayout& inset, double enlargement) {
  const Sizes& s = inset.sizes;
  const std::string times = shortNumber(enlargement, 2) + "\u00D7";
  const std::string longer = times + ", " + exaggerationText(inset);
  const float room = inset.plot.width - 14 * s.unit;
  const std::string& text = textWidth(longer, s.small) <= room ? longer : times;
  addLabel(list, text,
           {inset.plot.x + 7 * s.unit, std::round(inset.plot.y + 0.4F * s.small + 0.9F * s.small)},
           s.small, TextAnchor::Left, textOn(inset.theme.rigid));
}

}  // namespace

Box magnifierBox(const Frame& frame, const Magnifier& magnifier, const ContactLayout& layout) {
  const Box& plot = layout.plot;
  const float u = layout.sizes.unit, edge = std::round(10 * u);
  const float width = std::round(0.3F * plot.width), height = std::round(0.56F * plot.height);
  if (!isDrawable(frame) || width < kLeastWidth * u || height < kLeastHeight * u) return {};
  const float x = layout.px(magnifier.position);
  const bool isLeft = x > plot.x + 0.5F * plot.width;
  // Clear of the labels: on the left below the row of them, on the right at the bottom, away from
  // the forces.
  const float low = plot.bottom() - edge - height;
  const float top = plot.y + std::round(1.75F * (layout.sizes.small + 1)) + 2 * edge;
  if (isLeft) return {plot.x + edge, std::min(top, low), width, height};
  return {plot.right() - edge - width, low, width, height};
}

void addMagnifier(DrawList& list, const Frame& frame, const Magnifier& magnifier,
                  const ContactLayout& layout) {
  const Box box = magnifierBox(frame, magnifier, layout);
  if (!(box.width > 0)) return;
  removeTextsUnder(list, box);
  ContactLayout inset = layout;
  inset.plot = box;
  inset.view = partOf(frame, magnifier, layout, box.width);
  inset.heightTicks = {};
  inset.marked = narrowContact(frame, 4 * layout.sizes.unit / inset.pixelsPerMetreAlong());

  const float u = layout.sizes.unit;
  const Rgba& ink = layout.theme.text;
  DrawLayer below;
  below.clip = {layout.plot.x, layout.plot.y, layout.plot.width, layout.plot.height};
  const Box source = sourceBox(inset.view, layout);
  addBorder(below, source, 1.6F * u, ink);
  addConnection(below, source, box, 1.2F * u, withAlpha(ink, 0.55F));
  list.layers.push_back(std::move(below));
  addBodies(list, frame, inset);
  DrawLayer above;
  addScaleBars(list, above, inset);
  addBorder(above, box, 2.2F * u, ink);
  list.layers.push_back(std::move(above));
  addHeading(list, inset, inset.pixelsPerMetreAlong() / layout.pixelsPerMetreAlong());
}

}  // namespace asperity
