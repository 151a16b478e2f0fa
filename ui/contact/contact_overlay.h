// What the colours of a contact picture mean: pressure, time since contact or dissipated power.
// Pure; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/contact/contact_picture.h"

namespace asperity {

/// What a frame must hold for it.
FrameFields fieldsFor(ContactOverlay overlay);

/// "none", "pressure", "relaxation", "power".
std::string_view wordFor(ContactOverlay overlay);

struct ColourTick {
  float position;  // of the bar
  std::string label;
};

/// The way from a value to its colour; nothing is coloured where `maximum` is 0.
struct ColourScale {
  ContactOverlay overlay = ContactOverlay::None;
  double maximum = 0;  // N/m, s or W/m at the bar's end

  bool isShown() const { return overlay != ContactOverlay::None && maximum > 0; }
  /// Place on the bar, 0 to 1. Linear; of power three decades, because a few elements at the edges
  /// of contact take a hundred times what a free surface does.
  float position(double value) const;
  /// Only values above are coloured.
  double minimumShown() const;
  Rgba colour(double value) const { return colourAt(position(value)); }
  Rgba colourAt(float position) const;
  std::string title() const;
  std::string shortTitle() const;  // where there is no room for it
  /// Both ends, and between them round values or, of power, decades; the last one has the unit.
  std::vector<ColourTick> ticks(int most) const;
};

/// A few words on why the frame has nothing to colour; empty where it has, or where it is not known
/// because the frame lacks the values.
std::string reasonUncoloured(const Frame& frame, ContactOverlay overlay);

/// The values of the scale at the frame's points; empty where the frame lacks them.
const std::vector<double>& valuesOf(const Frame& frame, ContactOverlay overlay);

/// A round end of the scale for this frame, 0 where it has nothing to show. `last`: kept as long as
/// it does; of pressures only where those of the steady state are not known.
double scaleMaximum(const Frame& frame, ContactOverlay overlay, double last);

/// The end in a view.
double colourMaximum(const ContactView& view, ContactOverlay overlay);

}  // namespace asperity
