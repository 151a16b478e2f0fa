// The parts of a contact picture, each added to the list by one function. Private to ui/contact.
// Pure; any thread.
#pragma once

#include <string>
#include <vector>

#include "ui/contact/contact_layout.h"

namespace asperity {

/// Short remarks for the footer, the more important first.
using Notes = std::vector<std::string>;
inline constexpr const char* kNoteGap = "      ";  // between two of them

/// Title and readings; returns the pixels they take from the top.
float addHeader(DrawList& list, const Frame& frame, const ContactPictureOptions& options);

/// Both bodies, the gap, the curves and the lit contacts.
void addBodies(DrawList& list, const Frame& frame, const ContactLayout& layout);

/// What the bodies are, which way the line slides, the forces; after addBodies. Returns what the
/// footer has to say.
Notes addLabels(DrawList& list, const Frame& frame, const ContactLayout& layout);

/// Frame, ticks, axis titles, pressure legend, footer.
void addAxes(DrawList& list, const ContactLayout& layout, const Notes& notes);

}  // namespace asperity
