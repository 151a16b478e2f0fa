// What lies over a contact picture where somebody looks closer: a crosshair with its readout, and a
// magnified part in an inset. Private to ui/contact; pure.
#pragma once

#include "ui/contact/contact_layout.h"

namespace asperity {

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
