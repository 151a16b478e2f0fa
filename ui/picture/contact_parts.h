// The parts of a contact picture, each added to the list by one function. Private to ui/picture.
// Pure; any thread.
#pragma once

#include "ui/picture/contact_layout.h"

namespace asperity {

/// Title and readings; returns the pixels they take from the top.
float addHeader(DrawList& list, const Frame& frame, const ContactPictureOptions& options);

/// Both bodies, the gap, the curves and the lit contacts.
void addBodies(DrawList& list, const Frame& frame, const ContactLayout& layout);

/// What the bodies are, which way the line slides, the forces.
void addLabels(DrawList& list, const Frame& frame, const ContactLayout& layout);

/// Frame, ticks, axis titles, exaggeration, pressure legend.
void addAxes(DrawList& list, const ContactLayout& layout);

}  // namespace asperity
