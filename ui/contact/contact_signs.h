// The texts and symbols of a contact picture with their explanations: readings, labels, arrows,
// axes, the legend of the colours, the notes below the axes, each with its box. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/contact/contact_picture.h"

namespace asperity {

struct ContactSign {
  Box box;              // pixels
  std::string name;     // as it is written
  std::string_view id;  // of core/chart/explanations.h; empty: the tip is complete
  std::string tip{};    // a sentence on this frame; empty: that of the explanation
};

/// Returns the readings above the axes, each with a sentence about it. A title that does not fit
/// its line is the first one, with its full text as the sentence and no explanation.
std::vector<ContactSign> contactReadings(const Frame& frame, const ContactPictureOptions& options);

/// Returns all signs of the picture that composeContact makes, first the readings.
std::vector<ContactSign> contactSigns(const Frame& frame, const ContactPictureOptions& options);

/// Returns the sign under a pixel.
std::optional<ContactSign> contactSignAt(const Frame& frame, const ContactPictureOptions& options,
                                         float x, float y);

}  // namespace asperity
