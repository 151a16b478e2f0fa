// The labels inside the axes of a contact picture: what they say, and how they are painted. Private
// to ui/contact. Pure; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/run/frame.h"
#include "ui/contact/contact_layout.h"
#include "ui/contact/contact_signs.h"
#include "ui/draw/fonts.h"

namespace asperity {

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

/// Returns the direction of sliding with the velocity in several forms, the one with the most words
/// first; the last one has no velocity, which the header shows. None without a scene.
std::vector<Tag> slidingTags(const Frame& frame);

Tag rigidTag();

/// Returns the tags of the forces, the more important ones first; brief ones have fewer words.
/// Their arrows show the direction.
std::vector<Tag> forceTags(const Frame& frame, bool brief);

/// Returns "viscoelastic, G = 10 MPa, τ = 1 ms" or "G∞ = 1 MPa, 13 arms"; empty without a scene.
std::string elastomerWords(const Frame& frame);

/// Returns the full label first, then the name alone.
std::vector<Tag> elastomerTags(const Frame& frame);

}  // namespace asperity
