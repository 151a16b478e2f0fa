// The places of labels inside the axes. They are fixed in the corners, on translucent plates of
// their body's colour; in a low view, where the line reaches up to them, they are moved away from
// it.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ui/contact/contact_parts.h"
#include "ui/contact/contact_tags.h"
#include "ui/contact/frame_curves.h"
#include "ui/contact/label_placement.h"
#include "ui/draw/fonts.h"
#include "ui/draw/theme.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

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
  const auto place = [&](const Tag& tag, float preferred, bool exactly) {
    const float width = painter.width(tag);
    for (auto& [from, to] : spaces) {
      if (exactly && (preferred < from || preferred + width > to)) continue;
      const float nearest = std::clamp(preferred, from, std::max(from, to - width));
      const auto free = freeSpanAbove(line, {nearest, y, width, painter.height()},
                                      exactly ? preferred : from, exactly ? preferred + width : to);
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
  if (const std::vector<Tag> motion = slidingTags(frame); !motion.empty()) {
    labels.emplace_back();
    for (const Tag& words : motion)
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
/// labels of the forces are shortened where that lets more labels fit.
void addRigidTagsBetweenCrests(TagPainter& painter, const Frame& frame, const ContactLayout& layout,
                               float y) {
  const std::vector<Tag> forces = forceTags(frame, false);
  std::vector<PlacedTag> labels = placedBetweenCrests(painter, frame, layout, y, forces);
  const std::size_t all = 1 + forces.size() + (slidingTags(frame).empty() ? 0 : 1);
  if (labels.size() < all) {
    std::vector<PlacedTag> brief =
        placedBetweenCrests(painter, frame, layout, y, forceTags(frame, true));
    if (brief.size() > labels.size()) labels = std::move(brief);
  }
  for (const PlacedTag& label : labels) painter.paint(label.tag, {label.x, y}, layout.theme.rigid);
}

/// What stands beside the name of the rigid body in one row.
struct RowTags {
  std::optional<Tag> motion;
  std::vector<Tag> forces;
};

/// Returns the tags with the most words that fit this width with a gap beside each of them. The
/// words of the forces give way before those of the motion, and all of these before a force.
RowTags fittingTags(const TagPainter& painter, const Frame& frame, float available, float gap) {
  const std::vector<Tag> motions = slidingTags(frame);
  const auto fits = [&](const RowTags& tags) {
    float all = tags.motion ? painter.width(*tags.motion) + gap : 0;
    for (const Tag& force : tags.forces) all += gap + painter.width(force);
    return all <= available;
  };
  std::vector<RowTags> forms;
  for (const bool brief : {false, true})
    forms.push_back(
        {motions.empty() ? std::nullopt : std::optional(motions.front()), forceTags(frame, brief)});
  for (std::size_t i = 1; i < motions.size(); ++i)
    forms.push_back({motions[i], forms.back().forces});
  // The direction of friction is that against the motion, whose arrow stays.
  forms.push_back(forms.back());
  if (forms.back().forces.size() > 1) forms.back().forces.back().arrow = ArrowDirection::None;
  const std::size_t most = forms.front().forces.size();
  for (std::size_t left = 0; left <= most; ++left)
    for (RowTags tags : forms) {
      tags.forces.resize(most - left);
      if (fits(tags)) return tags;
    }
  return {};
}

/// Adds "rigid body" on the left, the motion in the middle, the forces on the right, if they fit.
void addRigidRow(TagPainter& painter, const Frame& frame, const ContactLayout& layout, float y) {
  const float gap = std::round(10 * layout.sizes.unit);
  const Rgba& plate = layout.theme.rigid;
  float left = layout.plot.x + gap, right = layout.plot.right() - gap;
  const Tag name = rigidTag();
  // A view of the elastomer alone has no rigid body in its corner.
  const bool isThere =
      isOnBody(Body::Rigid, frame, layout, {left, y, painter.width(name), painter.height()});
  if (isThere) painter.paint(name, {left, y}, plate);
  if (isThere) left += painter.width(name) + gap;
  const RowTags tags = fittingTags(painter, frame, right - left, gap);
  for (const Tag& force : tags.forces) {
    right -= painter.width(force);
    painter.paint(force, {right, y}, plate);
    right -= gap;
  }
  if (tags.motion) {
    const float width = painter.width(*tags.motion);
    const float middle = layout.plot.x + (layout.plot.width - width) / 2;
    return painter.paint(*tags.motion, {std::round(std::clamp(middle, left, right - width)), y},
                         plate);
  }
  // A narrow picture has the motion below the name.
  const std::vector<Tag> motions = slidingTags(frame);
  if (!isThere || motions.empty()) return;
  const Tag& motion = motions[std::min<std::size_t>(1, motions.size() - 1)];
  const float from = layout.plot.x + gap, below = y + painter.height();
  if (painter.width(motion) <= layout.plot.width - 2 * gap &&
      6 * painter.height() < layout.plot.height &&
      lineStaysBelow(frame, layout, below + painter.height()))
    painter.paint(motion, {from, below}, plate);
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
  const double power = isSteady ? frictionForce(frame.drawn()) * std::abs(frameVelocity(frame))
                                : whole * frame.spacing;
  if (!(whole > 0)) return Words::tr("nothing is dissipated");
  return filled(Words::tr("%1 total, %2 % in the free surface"),
                {quantity(power, "W"), shortNumber(100 * free / whole, 2)});
}

Notes notesFor(const Frame& frame, const ContactLayout& layout) {
  Notes notes{{exaggerationText(layout), "vertical exaggeration"}};
  const bool pressed = greatestPressure(frame) > 0;
  if (layout.marked && !layout.theme.isPaper)
    notes.push_back({pressed ? Words::tr("dot: the greatest line load")
                             : Words::tr("dot: a contact too small to be drawn"),
                     "dot at a contact"});
  if (layout.scale.overlay == ContactOverlay::Power && layout.scale.isShown())
    notes.push_back({powerText(frame), "dissipated power"});
  if (pressed && layout.scale.overlay == ContactOverlay::Pressure && !layout.theme.isPaper)
    notes.push_back({Words::tr("glow: line load, not depth"), "glow of the pressure"});
  return notes;
}

float footerWidth(const Notes& notes, const ContactLayout& layout) {
  float width = 0;
  for (const FooterNote& note : notes) width += textWidth(note.text + kNoteGap, layout.sizes.small);
  return width;
}

/// Puts the note into the footer, before a less important one; returns false where it does not fit.
bool footerWith(Notes& notes, const FooterNote& note, const ContactLayout& layout) {
  if (footerWidth({notes.front(), note}, layout) > layout.footerWidth) return false;
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
                std::vector<ContactSign>& signs) {
  Notes notes = notesFor(frame, layout);
  DrawLayer layer, plates;
  TagPainter painter(list, plates, layer, layout);
  const float margin = std::round(9 * layout.sizes.unit);
  const float rows = 2 * painter.height() + 3 * margin;
  if (!isDrawable(frame) || rows > 0.75F * layout.plot.height) return notes;
  const float row = layout.plot.y + margin;
  if (lineMisses(frame, layout, row, row + painter.height()))
    addRigidRow(painter, frame, layout, row);
  else
    addRigidTagsBetweenCrests(painter, frame, layout, row);
  nameElastomer(painter, frame, layout, notes);
  signs = painter.signs();
  list.layers.insert(list.layers.end() - 1, std::move(plates));  // the last layer has the curves
  list.layers.push_back(std::move(layer));
  return notes;
}

}  // namespace asperity
