// The parts of a contact picture, each added to the list by one function, and what lies over it
// where somebody looks closer: a crosshair with its readout, and a magnified part in an inset.
// Private to ui/contact. Pure; any thread.
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

/// Where the inset of the magnifier goes: into the half of the plot that it does not enlarge.
/// No width: the plot is too small for one.
Box magnifierBox(const Frame& frame, const Magnifier& magnifier, const ContactLayout& layout);

/// The inset: the neighbourhood at a larger scale, with bars for its scales and its exaggeration.
void addMagnifier(DrawList& list, const Frame& frame, const Magnifier& magnifier,
                  const ContactLayout& layout);

/// A vertical line at the element nearest to x, dots on line and surface, and a readout beside them
/// that covers neither. `taken`: a box to keep clear of, if that is possible.
void addProbe(DrawList& list, const Frame& frame, double x, const ContactLayout& layout,
              const Box& taken);

/// Leaves out the texts that a box laid over them would run into.
void removeTextsUnder(DrawList& list, const Box& box);

}  // namespace asperity
