// Labels inside the axes. They stand still in the corners, on soft plates of their body's colour.
#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/picture/colours.h"
#include "ui/picture/contact_parts.h"
#include "ui/picture/decimate.h"

namespace asperity {
namespace {

enum class ArrowWay { None, Left, Right, Down };

/// Words, an arrow, words.
struct Tag {
  TextRuns before;
  ArrowWay arrow = ArrowWay::None;
  TextRuns after;
};

class TagPainter {
 public:
  TagPainter(DrawList& list, DrawLayer& layer, const ContactLayout& layout)
      : list_(list),
        layer_(layer),
        layout_(layout),
        size_(layout.sizes.small + 1),
        inset_(std::round(9 * layout.sizes.unit)) {}

  float height() const { return std::round(size_ * 1.75F); }

  float width(const Tag& tag) const {
    float inner =
        textWidth(tag.before, size_) + textWidth(tag.after, size_) + arrowWidth(tag.arrow);
    if (!tag.before.empty() && tag.arrow != ArrowWay::None) inner += space();
    if (!tag.after.empty()) inner += space();
    return std::ceil(inner) + 2 * inset_;
  }

  void paint(const Tag& tag, Place topLeft, const Rgba& plate) {
    addPill(layer_, {topLeft.x, topLeft.y, width(tag), height()}, withAlpha(plate, 0.86F));
    const Rgba colour = textOn(plate);
    const float baseline = std::round(topLeft.y + height() / 2 + size_ * 0.36F);
    float x = topLeft.x + inset_;
    if (!tag.before.empty()) x = addText(list_, tag.before, {x, baseline}, size_, colour);
    if (tag.arrow != ArrowWay::None) {
      if (!tag.before.empty()) x += space();
      paintArrow(tag.arrow, x, topLeft.y + height() / 2, layout_.theme.highlight);
      x += arrowWidth(tag.arrow);
    }
    if (!tag.after.empty()) addText(list_, tag.after, {x + space(), baseline}, size_, colour);
  }

 private:
  float space() const { return std::round(size_ * 0.6F); }
  float arrowWidth(ArrowWay way) const {
    if (way == ArrowWay::None) return 0;
    return std::round(size_ * (way == ArrowWay::Down ? 0.8F : 2.6F));
  }

  void paintArrow(ArrowWay way, float x, float middle, const Rgba& colour) {
    const float u = layout_.sizes.unit, length = arrowWidth(way);
    Place from{x, middle}, to{x + length, middle};
    if (way == ArrowWay::Left) std::swap(from, to);
    if (way == ArrowWay::Down) {
      from = {x + length / 2, middle - height() * 0.34F};
      to = {x + length / 2, middle + height() * 0.34F};
    }
    addArrow(layer_, from, to, 8 * u, 2.4F * u, colour);
  }

  DrawList& list_;
  DrawLayer& layer_;
  const ContactLayout& layout_;
  float size_, inset_;
};

std::optional<Tag> slidingTag(const Frame& frame, bool brief) {
  if (!frame.scene) return std::nullopt;
  const double v = frame.scene->sliding.velocity;
  if (v == 0) return Tag{{{"rigid line at rest"}}, ArrowWay::None, {}};
  return Tag{{{brief ? "slides" : "rigid line slides"}},
             v > 0 ? ArrowWay::Right : ArrowWay::Left,
             {{"v = " + quantity(v, "m/s")}}};
}

Tag frictionTag(const Frame& frame) {
  const bool backwards = frame.scene && frame.scene->sliding.velocity < 0;
  return {{{"friction F"}, {"x", false, true}, {" = " + quantity(frame.tangentialForce, "N")}},
          backwards ? ArrowWay::Right : ArrowWay::Left,
          {}};
}

Tag pressingTag(const Frame& frame) {
  return {
      {{"F"}, {"N", false, true}, {" = " + quantity(frame.normalForce, "N")}}, ArrowWay::Down, {}};
}

/// The more important first.
std::vector<Tag> forceTags(const Frame& frame) {
  std::vector<Tag> tags;
  if (frame.normalForce > 0) tags.push_back(pressingTag(frame));
  if (frame.tangentialForce > 0) tags.push_back(frictionTag(frame));
  return tags;
}

Tag elastomerTag(const Frame& frame, bool brief) {
  Tag tag{{{"elastomer", true}}, ArrowWay::None, {}};
  if (brief || !frame.scene) return tag;
  const Elastomer& e = frame.scene->elastomer;
  const bool viscous = e.rheology == Rheology::Kelvin;
  std::string words = viscous ? "viscoelastic, G = " : "elastic, G = ";
  words += quantity(e.shearModulus, "Pa");
  if (viscous) words += ", \u03C4 = " + quantity(e.relaxationTime, "s");
  tag.after = {{words}};
  return tag;
}

/// "rigid body" on the left, the motion in the middle, the forces on the right, as far as they fit.
void addRigidRow(TagPainter& painter, const Frame& frame, const ContactLayout& layout, float y) {
  const float gap = std::round(10 * layout.sizes.unit);
  const Rgba& plate = layout.theme.rigid;
  float left = layout.plot.x + gap, right = layout.plot.right() - gap;
  const Tag name{{{"rigid body", true}}, ArrowWay::None, {}};
  std::optional<Tag> motion = slidingTag(frame, false);
  const auto both = [&] { return painter.width(name) + painter.width(*motion) + gap; };
  if (motion && both() > right - left) motion = slidingTag(frame, true);
  painter.paint(name, {left, y}, plate);
  if (motion && both() > right - left) {  // a narrow picture: one below the other
    if (painter.width(*motion) <= right - left && 6 * painter.height() < layout.plot.height)
      painter.paint(*motion, {left, y + painter.height()}, plate);
    return;
  }
  left += painter.width(name) + gap;
  for (const Tag& force : forceTags(frame)) {
    const float needed = painter.width(force) + gap;
    if (right - left < needed + (motion ? painter.width(*motion) + gap : 0)) break;
    painter.paint(force, {right - painter.width(force), y}, plate);
    right -= needed;
  }
  if (!motion) return;
  const float width = painter.width(*motion);
  const float middle = layout.plot.x + (layout.plot.width - width) / 2;
  painter.paint(*motion, {std::round(std::clamp(middle, left, right - width)), y}, plate);
}

}  // namespace

void addLabels(DrawList& list, const Frame& frame, const ContactLayout& layout) {
  DrawLayer layer;
  TagPainter painter(list, layer, layout);
  const float margin = std::round(9 * layout.sizes.unit);
  const float rows = 2 * painter.height() + 3 * margin;
  if (!isDrawable(frame) || rows > 0.75F * layout.plot.height) return;
  addRigidRow(painter, frame, layout, layout.plot.y + margin);
  for (const bool brief : {false, true}) {
    const Tag tag = elastomerTag(frame, brief);
    if (painter.width(tag) + 2 * margin > layout.plot.width) continue;
    painter.paint(tag, {layout.plot.x + margin, layout.plot.bottom() - margin - painter.height()},
                  mix(layout.theme.elastomer, {0, 0, 0, 1}, 0.2F));
    break;
  }
  list.layers.push_back(std::move(layer));
}

}  // namespace asperity
