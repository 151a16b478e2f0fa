// What the words and signs of a contact picture mean: readings, labels, arrows, axes, the legend of
// the colours, the remarks below the axes, each with its place and its explanation. Pure; any
// thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/contact/contact_picture.h"

namespace asperity {

struct ContactSign {
  Clip place;           // pixels
  std::string name;     // as it is written
  std::string_view id;  // of core/chart/explanations.h; empty: the tip says all
  std::string tip{};    // a sentence on this frame; empty: that of the explanation
};

/// Returns the signs of the picture that composeContact makes.
std::vector<ContactSign> contactSigns(const Frame& frame, const ContactPictureOptions& options);

/// Returns the sign under a pixel.
std::optional<ContactSign> contactSignAt(const Frame& frame, const ContactPictureOptions& options,
                                         float x, float y);

}  // namespace asperity
