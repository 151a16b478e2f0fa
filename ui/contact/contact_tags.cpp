#include "ui/contact/contact_tags.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "ui/draw/theme.h"

namespace asperity {

ContactSign signOf(const Tag& tag, const Box& box) {
  return {box, plainText(tag.before), tag.id, tag.tip, tag.handle};
}

TagPainter::TagPainter(DrawList& list, DrawLayer& plates, DrawLayer& arrows,
                       const ContactLayout& layout)
    : list_(list),
      plates_(plates),
      arrows_(arrows),
      layout_(layout),
      size_(layout.sizes.small + 1),
      inset_(std::round(9 * layout.sizes.unit)) {}

float TagPainter::height() const {
  return layout_.sizes.labelHeight();
}

float TagPainter::width(const Tag& tag) const {
  float inner = textWidth(tag.before, size_) + textWidth(tag.after, size_) + arrowWidth(tag.arrow);
  if (!tag.before.empty() && tag.arrow != ArrowDirection::None) inner += space();
  if (!tag.after.empty()) inner += space();
  return std::ceil(inner) + 2 * inset_;
}

void TagPainter::paint(const Tag& tag, DrawPoint topLeft, const Rgba& plate) {
  const Box box{topLeft.x, topLeft.y, width(tag), height()};
  signs_.push_back(signOf(tag, box));
  // A tag that is covered in part would lose its words, but not its plate.
  const auto covers = [&box](const Box& cover) { return cover.width > 0 && cover.overlaps(box); };
  if (std::ranges::any_of(layout_.covered, covers)) return;
  addPill(plates_, box, withAlpha(plate, 0.86F));
  const Rgba colour = textOn(plate);
  const float baseline = std::round(topLeft.y + height() / 2 + size_ * 0.36F);
  float x = topLeft.x + inset_;
  if (!tag.before.empty()) x = addText(list_, tag.before, {x, baseline}, size_, colour);
  if (tag.arrow != ArrowDirection::None) {
    if (!tag.before.empty()) x += space();
    paintArrow(tag.arrow, x, topLeft.y + height() / 2, layout_.theme.highlight);
    x += arrowWidth(tag.arrow);
  }
  if (!tag.after.empty()) addText(list_, tag.after, {x + space(), baseline}, size_, colour);
}

float TagPainter::space() const {
  return std::round(size_ * 0.6F);
}

float TagPainter::arrowWidth(ArrowDirection direction) const {
  if (direction == ArrowDirection::None) return 0;
  return std::round(size_ * (direction == ArrowDirection::Down ? 0.8F : 2.6F));
}

void TagPainter::paintArrow(ArrowDirection direction, float x, float middle, const Rgba& colour) {
  const float u = layout_.sizes.unit, length = arrowWidth(direction);
  DrawPoint from{x, middle}, to{x + length, middle};
  if (direction == ArrowDirection::Left) std::swap(from, to);
  if (direction == ArrowDirection::Down) {
    from = {x + length / 2, middle - height() * 0.34F};
    to = {x + length / 2, middle + height() * 0.34F};
  }
  addArrow(arrows_, from, to, 8 * u, 2.4F * u, colour);
}

}  // namespace asperity
