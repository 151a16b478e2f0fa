// The inset of a contact picture that enlarges one asperity.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/intervals.h"
#include "ui/contact/contact_parts.h"
#include "ui/contact/frame_curves.h"
#include "ui/contact/label_placement.h"
#include "ui/draw/fonts.h"
#include "ui/draw/theme.h"

namespace asperity {
namespace {

constexpr float kMinWidth = 110, kMinHeight = 74;  // units
constexpr int kMinPoints = 6;  // minimum number of the frame's points in the inset

/// Returns the heights of both curves in a view, m; 0 where there are none.
Extent heightsIn(const Frame& frame, const ContactView& view, float pixels) {
  const PointRange range = pointsWithin(frame, view.left, view.width);
  const Columns columns{view.left, pixels / view.width};
  Extent heights;
  for (const std::vector<double>* curve : {&frame.lineHeight, &frame.surfaceHeight})
    for (const CurveVertex& v : decimated(frame, *curve, range, columns)) heights.add(v.height);
  return heights.isEmpty() ? Extent{0, 0} : heights;
}

/// Returns the view of the inset, with at least the part `below` of its height free under both
/// curves. Its heights end at round values, so that they stay fixed while a contact is followed.
ContactView insetView(const Frame& frame, const Magnifier& magnifier, const ContactLayout& layout,
                      float pixels, double below) {
  constexpr double kAround = 1.6;  // times the curves' range
  ContactView view = layout.view;
  const double enlargement = magnifier.enlargement > 1 ? magnifier.enlargement : 1;
  view.width = std::max(pixels / layout.pixelsPerMetreX() / enlargement,
                        std::min(kMinPoints * frame.spacing, view.width));
  view.left = magnifier.position - 0.5 * view.width;
  const auto [low, high] = heightsIn(frame, view, pixels);
  const double least = 1e-3 * (layout.view.top - layout.view.bottom);
  const double range = std::max(high - low, least);
  constexpr double kAbove = 0.15;  // part of the height, for the heading
  const double size = roundUp(below > 0 ? range / (1 - below - kAbove) : kAround * range);
  const double grid = size / 20;
  const double bottom = below > 0 ? low - below * size : 0.5 * (low + high) - 0.55 * size;
  view.bottom = (below > 0 ? std::floor(bottom / grid) : std::round(bottom / grid)) * grid;
  view.top = view.bottom + size;
  return view;
}

/// Returns the enlarged box in the picture, at least a few pixels wide.
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

/// Adds lines from the enlarged part to the inset's near corners.
void addConnection(DrawLayer& layer, const Box& source, const Box& inset, float width,
                   const Rgba& colour) {
  const bool insetIsRight = inset.x > source.x;
  const float from = insetIsRight ? source.right() : source.x;
  const float to = insetIsRight ? inset.x : inset.right();
  addLine(layer, {{from, source.y}, {to, inset.y}}, width, colour);
  addLine(layer, {{from, source.bottom()}, {to, inset.bottom()}}, width, colour);
}

/// Returns a round length, 0.12 to 0.3 of the whole.
double barLength(double whole) {
  return roundUp125(0.12 * whole);
}

/// Two scale bars from a corner with their lengths, on a plate.
class ScaleBars {
 public:
  explicit ScaleBars(const ContactLayout& inset)
      : inset_(inset),
        horizontal_(barLength(inset.view.width)),
        vertical_(barLength(inset.view.top - inset.view.bottom)),
        width_(static_cast<float>(horizontal_ * inset.pixelsPerMetreX())),
        height_(static_cast<float>(vertical_ * inset.pixelsPerMetreY())) {}

  /// Returns the plate in the lower left corner, or in the right one.
  Box plate(bool isRight) const {
    const Sizes& s = inset_.sizes;
    const float u = s.unit, edge = std::round(4 * u);
    const float texts = std::max(textWidth(quantity(vertical_, "m"), s.small),
                                 width_ + 5 * u + textWidth(quantity(horizontal_, "m"), s.small));
    const Box box{inset_.plot.x + edge, 0, texts + 10 * u, height_ + 13 * u + s.small};
    return {isRight ? inset_.plot.right() - edge - box.width : box.x,
            inset_.plot.bottom() - edge - box.height, box.width, box.height};
  }

  void addTo(DrawList& list, DrawLayer& layer, const Box& plate) const {
    const Sizes& s = inset_.sizes;
    const float u = s.unit;
    const DrawPoint corner{plate.x + 5 * u, plate.bottom() - 5 * u};
    const Rgba ink = textOn(inset_.theme.elastomer);
    addRectangle(layer, plate, withAlpha(mix(inset_.theme.elastomer, {0, 0, 0, 1}, 0.3F), 0.75F));
    addLine(layer, {{corner.x, corner.y - height_}, corner, {corner.x + width_, corner.y}}, 2 * u,
            ink);
    addLabel(list, quantity(vertical_, "m"),
             {corner.x - 2 * u, std::round(corner.y - height_ - 5 * u)}, s.small, TextAnchor::Left,
             ink);
    addLabel(list, quantity(horizontal_, "m"),
             {corner.x + width_ + 5 * u, std::round(corner.y + 0.2F * s.small)}, s.small,
             TextAnchor::Left, ink);
  }

 private:
  const ContactLayout& inset_;
  double horizontal_, vertical_;  // m, of the bars
  float width_, height_;
};

/// Returns a plate for the bars that hides neither curve, so no contact; none where there is none.
std::optional<Box> clearPlate(const ScaleBars& bars, const Frame& frame,
                              const ContactLayout& inset) {
  const CurveRows line = curveRows(frame, frame.lineHeight, inset);
  const CurveRows surface = curveRows(frame, frame.surfaceHeight, inset);
  const Box& plot = inset.plot;
  for (const bool isRight : {false, true}) {
    const Box box = bars.plate(isRight);
    if (box.x >= plot.x && box.right() <= plot.right() && box.y >= plot.y && !line.crosses(box) &&
        !surface.crosses(box))
      return box;
  }
  return std::nullopt;
}

void addHeading(DrawList& list, const ContactLayout& inset, double enlargement) {
  const Sizes& s = inset.sizes;
  const std::string times = shortNumber(enlargement, 2) + "\u00D7";
  const std::string longer = times + ", " + exaggerationText(inset);
  const float available = inset.plot.width - 14 * s.unit;
  const std::string& text = textWidth(longer, s.small) <= available ? longer : times;
  addLabel(list, text,
           {inset.plot.x + 7 * s.unit, std::round(inset.plot.y + 0.4F * s.small + 0.9F * s.small)},
           s.small, TextAnchor::Left, textOn(inset.theme.rigid));
}

/// Sets the view of the inset, and returns the position of its scale bars: a corner without
/// contact. Where neither corner is free, the space below the contact is enlarged; there are no
/// bars where this would leave nothing visible.
std::optional<Box> zoomIn(ContactLayout& inset, const Frame& frame, const Magnifier& magnifier,
                          const ContactLayout& layout) {
  std::optional<Box> plate;
  for (const double below : {0.0, 0.3, 0.4, 0.5}) {
    inset.view = insetView(frame, magnifier, layout, inset.plot.width, below);
    plate = clearPlate(ScaleBars(inset), frame, inset);
    if (plate) return plate;
  }
  inset.view = insetView(frame, magnifier, layout, inset.plot.width, 0);
  return plate;
}

}  // namespace

Box magnifierBox(const Frame& frame, const Magnifier& magnifier, const ContactLayout& layout) {
  const Box& plot = layout.plot;
  const float u = layout.sizes.unit, edge = std::round(10 * u);
  // In a small plot, the inset takes a larger part.
  const float width = std::round(std::max(0.3F * plot.width, kMinWidth * u));
  const float height = std::round(std::max(0.56F * plot.height, kMinHeight * u));
  if (!isDrawable(frame) || width > 0.45F * plot.width || height > 0.7F * plot.height) return {};
  const float x = layout.px(magnifier.position);
  const bool isLeft = x > plot.x + 0.5F * plot.width;
  // The inset avoids the labels: on the left it is below their row, on the right it is at the
  // bottom, away from the forces.
  const float low = plot.bottom() - edge - height;
  const float top = plot.y + layout.sizes.labelHeight() + 2 * edge;
  // In a low plot it ends above the elastomer's name, where that leaves enough of it.
  const float name = plot.bottom() - std::round(9 * u) - layout.sizes.labelHeight();
  const float above = name - std::round(4 * u) - top;
  if (isLeft && above >= 0.8F * kMinHeight * u)
    return {plot.x + edge, top, width, std::min(height, above)};
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
  inset.heightTicks = {};
  const std::optional<Box> plate = zoomIn(inset, frame, magnifier, layout);
  inset.marked = narrowContact(frame, 4 * layout.sizes.unit / inset.pixelsPerMetreX());

  const float u = layout.sizes.unit;
  const Rgba& ink = layout.theme.text;
  DrawLayer below;
  below.clip = layout.plot;
  const Box source = sourceBox(inset.view, layout);
  addOutline(below, source, 1.6F * u, ink);
  addConnection(below, source, box, 1.2F * u, withAlpha(ink, 0.55F));
  list.layers.push_back(std::move(below));
  addBodies(list, frame, inset);
  DrawLayer above;
  if (plate) ScaleBars(inset).addTo(list, above, *plate);
  addOutline(above, box, 2.2F * u, ink);
  list.layers.push_back(std::move(above));
  addHeading(list, inset, inset.pixelsPerMetreX() / layout.pixelsPerMetreX());
}

}  // namespace asperity
