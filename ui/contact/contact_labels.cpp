// Labels inside the axes. They are fixed in the corners, on translucent plates of their body's
// colour; in a low view, where the line reaches up to them, they are moved away from it.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/material/element_law.h"
#include "ui/contact/contact_forces.h"
#include "ui/contact/contact_parts.h"
#include "ui/contact/frame_curves.h"
#include "ui/contact/label_placement.h"
#include "ui/draw/fonts.h"
#include "ui/draw/theme.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

// ---- Tags

enum class ArrowDirection { None, Left, Right, Down };

/// A label: words, an arrow, words.
struct Tag {
  TextRuns before;
  ArrowDirection arrow = ArrowDirection::None;
  TextRuns after;
  ContactHandle handle = ContactHandle::None;  // what a drag of it changes
  std::string_view id{};                       // of its explanation
  std::string tip{};                           // a sentence instead of that of the explanation
};

/// Returns the sign that a tag, or its arrow, is in this box.
ContactSign makeSign(const Tag& tag, const Box& box) {
  return {box, plainText(tag.before), tag.id, tag.tip, tag.handle};
}

/// Paints tags, all in one size: their plates in one layer, their arrows in another. The list,
/// layers and layout must outlive it.
class TagPainter {
 public:
  TagPainter(DrawList& list, DrawLayer& plates, DrawLayer& arrows, const ContactLayout& layout);

  float height() const;
  float width(const Tag& tag) const;
  void paint(const Tag& tag, DrawPoint topLeft, const Rgba& plate);
  /// Returns the tags painted so far.
  const std::vector<ContactSign>& signs() const { return signs_; }

 private:
  float space() const;
  float arrowWidth(ArrowDirection direction) const;
  void paintArrow(ArrowDirection direction, float x, float middle, const Rgba& colour);

  DrawList& list_;
  DrawLayer &plates_, &arrows_;
  const ContactLayout& layout_;
  float size_, inset_;
  std::vector<ContactSign> signs_;
};

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
  signs_.push_back(makeSign(tag, box));
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

// ---- The words of the tags

std::optional<Tag> slidingTag(const Frame& frame, bool brief) {
  if (!frame.scene) return std::nullopt;
  const double v = frameVelocity(frame);
  if (v == 0)
    return Tag{{{Words::tr("rigid line at rest")}},
               ArrowDirection::None,
               {},
               ContactHandle::Velocity,
               "sliding.velocity"};
  return Tag{{{brief ? Words::tr("slides") : Words::tr("rigid line slides")}},
             v > 0 ? ArrowDirection::Right : ArrowDirection::Left,
             {{"v = " + quantity(v, "m/s")}},
             ContactHandle::Velocity,
             "sliding.velocity"};
}

Tag rigidTag() {
  return {{{Words::tr("rigid body"), true}},
          ArrowDirection::None,
          {},
          ContactHandle::Body,
          "rigid body"};
}

/// Returns "tangential force F", in a brief label "F". The index x follows.
std::string frictionName(const Frame& frame, bool brief) {
  if (hasInterface(frame))
    return brief ? Words::tr("total F") : Words::tr("tangential force in total F");
  return brief ? "F" : Words::tr("tangential force F");
}

std::string frictionSentence() {
  return Words::tr("The force that sliding takes. It is a result and cannot be dragged.");
}

/// Returns the tag of friction. Arrows in tags show only the direction; where there is space,
/// arrows to scale are drawn instead.
Tag frictionTag(const Frame& frame, const ForceArrows& arrows, bool brief) {
  const bool toTheRight = pushesRight(frame);
  Tag tag{{{frictionName(frame, brief)},
           {"x", false, true},
           {" = " + quantity(frictionForce(drawnState(frame)), "N")}},
          toTheRight ? ArrowDirection::Right : ArrowDirection::Left,
          {},
          ContactHandle::None,
          hasInterface(frame) ? "total friction" : "tangential_force",
          frictionSentence()};
  if (!(arrows.sideways > 0)) return tag;
  tag.arrow = ArrowDirection::None;
  if (arrows.enlarged > 1)
    tag.before.push_back({filled(Words::tr(", arrow %1\u00D7"), {shortNumber(arrows.enlarged)})});
  return tag;
}

Tag normalForceTag(const Frame& frame, const ForceArrows& arrows) {
  return {{{"F"}, {"N", false, true}, {" = " + quantity(drawnState(frame).normalForce, "N")}},
          arrows.down > 0 ? ArrowDirection::None : ArrowDirection::Down,
          {},
          ContactHandle::Force,
          "load.normal_force"};
}

/// Returns the tags of the forces, the more important ones first; brief ones have fewer words.
std::vector<Tag> forceTags(const Frame& frame, const ForceArrows& arrows, bool brief) {
  std::vector<Tag> tags;
  const ContactState state = drawnState(frame);
  if (state.normalForce > 0) tags.push_back(normalForceTag(frame, arrows));
  // Without steady friction (no friction, or a state without it) rounding errors get no arrow.
  if (totalFriction(state) > 0 && frictionForce(state) > 0)
    tags.push_back(frictionTag(frame, arrows, brief));
  return tags;
}

/// Returns "viscoelastic, G = 10 MPa, τ = 1 ms" or "G∞ = 1 MPa, 13 arms"; empty without a scene.
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
                        {modulus, time, quantity(elastomer.temperature, "K")});
  }
  return filled(law.arms.size() == 1 ? Words::tr("viscoelastic, G\u221E = %1, %2 arm")
                                     : Words::tr("viscoelastic, G\u221E = %1, %2 arms"),
                {modulus, std::to_string(law.arms.size())});
}

/// Returns the full label first, then the name alone.
std::vector<Tag> elastomerTags(const Frame& frame) {
  Tag name{
      {{Words::tr("elastomer"), true}}, ArrowDirection::None, {}, ContactHandle::None, "elastomer"};
  const std::string words = elastomerWords(frame);
  if (words.empty()) return {name};
  Tag whole = name;
  whole.after = {{words}};
  return {whole, name};
}

// ---- The places of the tags

struct PlacedTag {
  Tag tag;
  float x = 0;
};

/// Places labels in a row where the line leaves space for them. Those of the last picture stay
/// where they were if they can; others are as near to their usual positions as possible: the body
/// on the left, the forces on the right, F_N outermost, the motion in the middle in as many of its
/// words as fit. A label that does not fit is left out, because the line would cross it.
std::vector<PlacedTag> placedBetweenCrests(const TagPainter& painter, const Frame& frame,
                                           const ContactLayout& layout, float y,
                                           std::span<const Tag> forces) {
  const float gap = std::round(10 * layout.sizes.unit);
  const float left = layout.plot.x + gap, right = layout.plot.right() - gap;
  const CurveRows line = curveRows(frame, frame.lineHeight, layout);
  std::vector<std::pair<float, float>> spaces{{left, right}};
  std::vector<PlacedTag> placed;
  const auto place = [&](const Tag& tag, float wanted, bool exactly) {
    const float width = painter.width(tag);
    for (auto& [from, to] : spaces) {
      if (exactly && (wanted < from || wanted + width > to)) continue;
      const float nearest = std::clamp(wanted, from, std::max(from, to - width));
      const auto free = freeSpanAbove(line, {nearest, y, width, painter.height()},
                                      exactly ? wanted : from, exactly ? wanted + width : to);
      if (!free) continue;
      const float x = std::round(*free);
      placed.push_back({tag, x});
      const std::pair after{x + width + gap, to};
      to = x - gap;
      spaces.push_back(after);
      return true;
    }
    return false;
  };
  // Each label in its forms, the one with the most words first, and its usual position.
  std::vector<std::vector<PlacedTag>> labels;
  labels.push_back({{rigidTag(), left}});
  for (const Tag& force : forces) labels.push_back({{force, right}});
  if (const std::optional<Tag> motion = slidingTag(frame, false)) {
    const Tag brief = slidingTag(frame, true).value_or(*motion);
    Tag briefest = brief;
    briefest.after.clear();  // the header shows the velocity
    labels.emplace_back();
    for (const Tag& words : {*motion, brief, briefest})
      labels.back().push_back(
          {words, layout.plot.x + (layout.plot.width - painter.width(words)) / 2});
  }
  std::erase_if(labels, [&](const std::vector<PlacedTag>& forms) {
    const std::optional<float> last = layout.lastPlace(forms.front().tag.id);
    return last && std::ranges::any_of(
                       forms, [&](const PlacedTag& form) { return place(form.tag, *last, true); });
  });
  for (const std::vector<PlacedTag>& forms : labels)
    for (const PlacedTag& form : forms)
      if (place(form.tag, form.x, false)) break;
  return placed;
}

/// Names the rigid body, its motion and the forces in spaces that the line leaves free now. The
/// labels of the forces contain their arrows, and are shortened where that lets more labels fit.
void addRigidTagsBetweenCrests(TagPainter& painter, const Frame& frame, const ContactLayout& layout,
                               float y) {
  const std::vector<Tag> forces = forceTags(frame, {}, false);
  std::vector<PlacedTag> labels = placedBetweenCrests(painter, frame, layout, y, forces);
  const std::size_t all = 1 + forces.size() + (slidingTag(frame, false) ? 1 : 0);
  if (labels.size() < all) {
    std::vector<PlacedTag> brief =
        placedBetweenCrests(painter, frame, layout, y, forceTags(frame, {}, true));
    if (brief.size() > labels.size()) labels = std::move(brief);
  }
  for (const PlacedTag& label : labels) painter.paint(label.tag, {label.x, y}, layout.theme.rigid);
}

/// Returns where arrows may begin under the row of labels whose upper edge is at y.
float belowRow(const TagPainter& painter, const ContactLayout& layout, float y) {
  return y + painter.height() + std::round(9 * layout.sizes.unit);
}

/// Adds "rigid body" on the left, the motion in the middle, the forces on the right, if they fit.
void addRigidRow(TagPainter& painter, const Frame& frame, const ContactLayout& layout, float y) {
  const float gap = std::round(10 * layout.sizes.unit);
  const Rgba& plate = layout.theme.rigid;
  float left = layout.plot.x + gap, right = layout.plot.right() - gap;
  const Tag name = rigidTag();
  std::optional<Tag> motion = slidingTag(frame, false);
  const auto both = [&] { return painter.width(name) + painter.width(*motion) + gap; };
  if (motion && both() > right - left) motion = slidingTag(frame, true);
  // A view of the elastomer alone has no rigid body in its corner.
  const bool isThere =
      isOnBody(Body::Rigid, frame, layout, {left, y, painter.width(name), painter.height()});
  if (isThere) painter.paint(name, {left, y}, plate);
  if (motion && isThere && both() > right - left) {  // a narrow picture has them below each other
    const float below = y + painter.height();
    if (painter.width(*motion) <= right - left && 6 * painter.height() < layout.plot.height &&
        lineStaysBelow(frame, layout, below + painter.height()))
      painter.paint(*motion, {left, below}, plate);
    return;
  }
  if (isThere) left += painter.width(name) + gap;
  const ForceArrows arrows = forceArrows(frame, layout, belowRow(painter, layout, y));
  std::vector<Tag> forces = forceTags(frame, arrows, false);
  const auto fitAll = [&] {
    float all = motion ? painter.width(*motion) + gap : 0;
    for (const Tag& force : forces) all += gap + painter.width(force);
    return all <= right - left;
  };
  if (!fitAll()) forces = forceTags(frame, arrows, true);
  if (!fitAll() && motion) motion = slidingTag(frame, true);
  for (const Tag& force : forces) {
    const float needed = painter.width(force) + gap;
    if (right - left < needed + (motion ? painter.width(*motion) + gap : 0)) break;
    painter.paint(force, {right - painter.width(force), y}, plate);
    right -= needed;
  }
  if (!motion || painter.width(*motion) > right - left) return;
  const float width = painter.width(*motion);
  const float middle = layout.plot.x + (layout.plot.width - width) / 2;
  painter.paint(*motion, {std::round(std::clamp(middle, left, right - width)), y}, plate);
}

/// Returns "200 \u00B5W total, 23 % in the free surface": the recovering surface takes power, too.
/// In steady sliding the total is exactly the work of the friction force per time, including that
/// of the interface; the sum over points, which gives the parts, is only an approximation.
std::string powerText(const Frame& frame) {
  double free = 0, whole = 0;
  for (std::size_t i = 0; i < frame.power.size(); ++i) {
    whole += frame.power[i];
    if (!(frame.pressure[i] > 0)) free += frame.power[i];
  }
  const bool isSteady = !frame.transient && !frame.isSettling;
  const double power = isSteady ? frictionForce(drawnState(frame)) * std::abs(frameVelocity(frame))
                                : whole * frame.spacing;
  if (!(whole > 0)) return Words::tr("nothing is dissipated");
  return filled(Words::tr("%1 total, %2 % in the free surface"),
                {quantity(power, "W"), shortNumber(100 * free / whole, 2)});
}

Notes notesFor(const Frame& frame, const ContactLayout& layout) {
  Notes notes{{exaggerationText(layout), "vertical exaggeration"}};
  const bool pressed = greatestPressure(frame) > 0;
  if (layout.marked && !layout.theme.isPaper)
    notes.push_back({pressed ? Words::tr("dot: the greatest pressure")
                             : Words::tr("dot: a contact too small to be drawn"),
                     "dot at a contact"});
  if (layout.scale.overlay == ContactOverlay::Power && layout.scale.isShown())
    notes.push_back({powerText(frame), "dissipated power"});
  if (pressed && layout.scale.overlay == ContactOverlay::Pressure && !layout.theme.isPaper)
    notes.push_back({Words::tr("glow: pressure, not depth"), "glow of the pressure"});
  return notes;
}

float footerWidth(const Notes& notes, const ContactLayout& layout) {
  float width = 0;
  for (const FooterNote& note : notes) width += textWidth(note.text + kNoteGap, layout.sizes.small);
  return width;
}

/// Puts the note into the footer, before a less important one; returns false where it does not fit.
bool footerWith(Notes& notes, const FooterNote& note, const ContactLayout& layout) {
  Notes wanted{notes.front(), note};
  if (footerWidth(wanted, layout) > layout.footerWidth) return false;
  notes.insert(notes.begin() + 1, note);
  return true;
}

/// Names the elastomer where the label hides no contact: at the bottom left if no contact ever gets
/// there, so that the label stays fixed; otherwise in the footer; otherwise in a space that is free
/// now.
void nameElastomer(TagPainter& painter, const Frame& frame, const ContactLayout& layout,
                   Notes& notes) {
  const float margin = std::round(9 * layout.sizes.unit);
  const std::vector<Tag> tags = elastomerTags(frame);
  const Theme& t = layout.theme;
  const Rgba plate = t.isPaper ? t.elastomer : mix(t.elastomer, {0, 0, 0, 1}, 0.2F);
  // In a low view the name stands lower, so that the surface does not cross its letters.
  const float clearance = std::round(2 * layout.sizes.unit);
  const float lowest = layout.plot.bottom() - painter.height();
  const float top =
      std::clamp(std::round(layout.py(0)) + clearance, lowest - margin, lowest - clearance);
  const auto fits = [&](const Tag& tag) {
    return painter.width(tag) + 2 * margin <= layout.plot.width;
  };
  const auto isOnElastomer = [&](const Tag& tag, float x) {
    return isOnBody(Body::Elastomer, frame, layout, {x, top, painter.width(tag), painter.height()});
  };
  if (clearAcross(frame, layout, top)) {
    const auto tag = std::find_if(tags.begin(), tags.end(), fits);
    const float left = layout.plot.x + margin;
    if (tag != tags.end() && isOnElastomer(*tag, left)) painter.paint(*tag, {left, top}, plate);
    return;
  }
  const std::string words = elastomerWords(frame);
  const FooterNote note{words.empty() ? Words::tr("below: the elastomer")
                                      : filled(Words::tr("elastomer: %1"), {words}),
                        "elastomer"};
  if (layout.footer > 0 && footerWith(notes, note, layout)) return;
  for (const Tag& tag : tags) {
    if (!fits(tag)) continue;
    const auto x =
        labelPlacement(frame, layout, top, painter.width(tag), margin, layout.lastPlace(tag.id));
    if (x && isOnElastomer(tag, *x)) return painter.paint(tag, {*x, top}, plate);
  }
}

}  // namespace

float labelRowBottom(const ContactLayout& layout) {
  return layout.plot.y + std::round(9 * layout.sizes.unit) + layout.sizes.labelHeight();
}

Notes addLabels(DrawList& list, const Frame& frame, const ContactLayout& layout,
                std::vector<ContactSign>* signs) {
  Notes notes = notesFor(frame, layout);
  DrawLayer layer, plates;
  TagPainter painter(list, plates, layer, layout);
  const float margin = std::round(9 * layout.sizes.unit);
  const float rows = 2 * painter.height() + 3 * margin;
  if (!isDrawable(frame) || rows > 0.75F * layout.plot.height) return notes;
  const float row = layout.plot.y + margin;
  const bool hasRow = lineMisses(frame, layout, row, row + painter.height());
  if (hasRow)
    addRigidRow(painter, frame, layout, row);
  else
    addRigidTagsBetweenCrests(painter, frame, layout, row);
  const float top = belowRow(painter, layout, row);
  const ForceArrows arrows = hasRow ? forceArrows(frame, layout, top) : ForceArrows{};
  if (arrows.down > 0)
    addForceArrows({plates, layer}, arrows, arrowFoot(arrows, layout, top), layout);
  nameElastomer(painter, frame, layout, notes);
  if (signs) {
    *signs = painter.signs();
    if (arrows.down > 0) {
      const DrawPoint foot = arrowFoot(arrows, layout, top);
      const float reach = 9 * layout.sizes.unit;
      signs->push_back(makeSign(normalForceTag(frame, arrows),
                                {foot.x - reach, foot.y, 2 * reach, arrows.down + reach}));
      if (arrows.sideways > 0) {
        const float from = arrows.pointsRight ? foot.x : foot.x - arrows.sideways;
        signs->push_back(makeSign(frictionTag(frame, arrows, false),
                                  {from, foot.y - reach, arrows.sideways, 2 * reach}));
      }
    }
  }
  list.layers.insert(list.layers.end() - 1, std::move(plates));  // the last layer has the curves
  list.layers.push_back(std::move(layer));
  return notes;
}

}  // namespace asperity
