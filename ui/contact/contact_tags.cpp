#include "ui/contact/contact_tags.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "core/material/element_law.h"
#include "ui/contact/frame_curves.h"
#include "ui/draw/shapes.h"
#include "ui/draw/theme.h"
#include "ui/language/language.h"
#include "ui/language/translated.h"

namespace asperity {

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
  signs_.push_back({box, plainText(tag.before), tag.id, tag.tip, tag.handle});
  // A tag that is covered in part would lose its words, but not its plate.
  const auto covers = [&box](const Box& cover) { return cover.width > 0 && cover.overlaps(box); };
  if (std::ranges::any_of(layout_.covered, covers)) return;
  addPill(plates_, box, withAlpha(plate, 0.86F));
  const Rgba colour = textOn(plate);
  const float baseline = std::round(topLeft.y + height() / 2 + size_ * kMiddleOfText);
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

// ---- The words of the tags

std::vector<Tag> slidingTags(const Frame& frame) {
  if (!frame.scene) return {};
  const double v = frameVelocity(frame);
  Tag whole{{{v == 0 ? Words::tr("rigid line at rest") : Words::tr("rigid line slides")}},
            ArrowDirection::None,
            {},
            ContactHandle::Velocity,
            "sliding.velocity"};
  if (v == 0) return {whole};
  whole.arrow = v > 0 ? ArrowDirection::Right : ArrowDirection::Left;
  whole.after = {{"v = " + quantity(v, "m/s")}};
  Tag brief = whole;
  brief.before = {{Words::tr("slides")}};
  Tag briefest = brief;
  briefest.after.clear();
  return {whole, brief, briefest};
}

Tag rigidTag() {
  return {{{Words::tr("rigid body"), true}},
          ArrowDirection::None,
          {},
          ContactHandle::Body,
          "rigid body"};
}

namespace {

/// Returns "tangential force F", in a brief label "F". The index x follows.
std::string frictionName(const Frame& frame, bool brief) {
  if (hasInterface(frame))
    return brief ? Words::tr("total F") : Words::tr("tangential force in total F");
  return brief ? "F" : Words::tr("tangential force F");
}

Tag normalForceTag(const Frame& frame) {
  return {{{"F"}, {"N", false, true}, {" = " + quantity(frame.drawn().normalForce, "N")}},
          ArrowDirection::Down,
          {},
          ContactHandle::Force,
          "load.normal_force"};
}

Tag frictionTag(const Frame& frame, bool brief) {
  return {{{frictionName(frame, brief)},
           {"x", false, true},
           {" = " + quantity(frictionForce(frame.drawn()), "N")}},
          pushesRight(frame) ? ArrowDirection::Right : ArrowDirection::Left,
          {},
          ContactHandle::None,
          hasInterface(frame) ? "total friction" : "tangential_force",
          Words::tr("The force that sliding takes. It is a result and cannot be dragged.")};
}

}  // namespace

std::vector<Tag> forceTags(const Frame& frame, bool brief) {
  std::vector<Tag> tags;
  const ContactState& state = frame.drawn();
  if (state.normalForce > 0) tags.push_back(normalForceTag(frame));
  // Without friction (none, a state without it, or one below its own error, as after a stop)
  // rounding errors get no arrow.
  const bool isKnown = !(frame.transient && totalFriction(state) < frame.muError);
  if (totalFriction(state) > 0 && frictionForce(state) > 0 && isKnown)
    tags.push_back(frictionTag(frame, brief));
  return tags;
}

std::string elastomerWords(const Frame& frame) {
  if (!frame.scene) return {};
  const Elastomer& elastomer = frame.scene->elastomer;
  const ElementLaw law = elementLaw(elastomer);
  const ElementKind kind = law.kind();
  const std::string modulus = quantity(law.equilibriumModulus, "Pa");
  if (kind == ElementKind::Elastic) return filled(Words::tr("elastic, G = %1"), {modulus});
  if (kind == ElementKind::Kelvin) {
    const std::string time = quantity(law.relaxationTime, "s");
    // The panel has the relaxation time at the reference temperature.
    return law.relaxationTime == elastomer.relaxationTime
               ? filled(Words::tr("viscoelastic, G = %1, \u03C4 = %2"), {modulus, time})
               : filled(Words::tr("viscoelastic, G = %1, \u03C4 = %2 at %3"),
                        {modulus, time, translated(celsius(elastomer.temperature))});
  }
  return filled(law.arms.size() == 1 ? Words::tr("viscoelastic, G\u221E = %1, %2 arm")
                                     : Words::tr("viscoelastic, G\u221E = %1, %2 arms"),
                {modulus, std::to_string(law.arms.size())});
}

std::vector<Tag> elastomerTags(const Frame& frame) {
  Tag name{
      {{Words::tr("elastomer"), true}}, ArrowDirection::None, {}, ContactHandle::None, "elastomer"};
  const std::string words = elastomerWords(frame);
  if (words.empty()) return {name};
  Tag whole = name;
  whole.after = {{words}};
  return {whole, name};
}

}  // namespace asperity
