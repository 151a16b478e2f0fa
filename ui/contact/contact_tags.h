// Short labels inside the axes: words and an arrow on a translucent plate. Private to ui/contact.
// One thread at a time.
#pragma once

#include <string>

#include "ui/contact/contact_layout.h"
#include "ui/contact/contact_signs.h"

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

/// Returns the sign that a tag, or its arrow, is in this box.
ContactSign signOf(const Tag& tag, const Box& box);

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

}  // namespace asperity
