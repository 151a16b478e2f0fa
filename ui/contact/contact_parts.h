// The parts of a contact picture, each added to the list by one function, and the tools for
// details: a crosshair with its readout, and a magnified inset. Private to ui/contact. Pure; any
// thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/contact/contact_layout.h"
#include "ui/contact/contact_signs.h"
#include "ui/contact/frame_curves.h"

namespace asperity {

/// A short remark in the footer, with the id of its explanation.
struct FooterNote {
  std::string text;
  std::string_view id;
};
/// The more important ones first.
using Notes = std::vector<FooterNote>;
inline constexpr const char* kNoteGap = "      ";  // between two of them

/// A picture of which the title and readings are drawn, and nothing below them.
struct PreparedPicture {
  ContactPictureOptions options;  // with a size of at least one pixel
  DrawList list;
  ContactLayout layout;
};
PreparedPicture prepareContact(const Frame& frame, const ContactPictureOptions& requested);

/// Adds title and readings; returns the pixels that they take from the top.
float addHeader(DrawList& list, const Frame& frame, const ContactPictureOptions& options);

/// Adds both bodies, the gap, the curves and the coloured contacts.
void addBodies(DrawList& list, const Frame& frame, const ContactLayout& layout);

/// Returns the depth of the light below the contacts in pixels; its lower half is hardly visible.
float glowDepth(const ContactLayout& layout);

/// Adds the names of the bodies, the direction of sliding and the forces; call it after addBodies.
/// Returns the texts for the footer. signs: receives the labels and arrows.
Notes addLabels(DrawList& list, const Frame& frame, const ContactLayout& layout,
                std::vector<ContactSign>& signs);

/// Returns the lower end of the row of labels at the top of the plot, a pixel row.
float labelRowBottom(const ContactLayout& layout);

/// Returns the notes that fit into the footer.
Notes shownNotes(const ContactLayout& layout, const Notes& notes);

/// Returns the title of the height axis, the short one where the axis is low.
std::string heightAxisTitle(const ContactLayout& layout);

/// Adds frame, ticks, axis titles, colour legend and footer.
void addAxes(DrawList& list, const ContactLayout& layout, const Notes& notes);

/// Returns the box of the inset: in the half of the plot that it does not enlarge. Width 0: the
/// plot is too small for one.
Box magnifierBox(const Frame& frame, const Magnifier& magnifier, const ContactLayout& layout);

/// Adds the inset: the neighbourhood at a larger scale, with scale bars and its exaggeration.
void addMagnifier(DrawList& list, const Frame& frame, const Magnifier& magnifier,
                  const ContactLayout& layout);

/// Adds a vertical line at the element nearest to x, dots on line and surface, and a readout beside
/// them that covers neither. `taken`: a box to avoid, if that is possible.
void addProbe(DrawList& list, const Frame& frame, double x, const ContactLayout& layout,
              const Box& taken);

/// Returns the box of that readout; width 0 where there is none.
Box readoutBox(const Frame& frame, double x, const ContactLayout& layout, const Box& taken);

/// Removes the texts that a box over them would touch.
void removeTextsUnder(DrawList& list, const Box& box);

}  // namespace asperity
