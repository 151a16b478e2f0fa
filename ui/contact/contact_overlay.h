// The meaning of the colours in a contact picture: pressure, time since contact or dissipated
// power. Pure; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/named_choices.h"
#include "ui/contact/contact_picture.h"

namespace asperity {

/// The words of the overlays, in options, settings and names of actions.
inline constexpr NamedChoices<ContactOverlay, 4> kContactOverlays{
    {{"none", ContactOverlay::None},
     {"pressure", ContactOverlay::Pressure},
     {"relaxation", ContactOverlay::Relaxation},
     {"power", ContactOverlay::Power}}};

/// Returns the optional values that a frame must contain for the overlay.
FrameFields fieldsFor(ContactOverlay overlay);

/// Returns the id of its explanation (core/chart/explanations.h); empty for None.
std::string_view explanationId(ContactOverlay overlay);

struct ColourTick {
  float position;  // on the bar, 0 to 1
  std::string label;
};

/// The map from a value to its colour; nothing is coloured where `maximum` is 0.
struct ColourScale {
  ContactOverlay overlay = ContactOverlay::None;
  double maximum = 0;  // N/m, s or W/m at the right end of the bar

  bool isShown() const { return overlay != ContactOverlay::None && maximum > 0; }
  /// Returns the position on the bar, 0 to 1. It is linear; power has three decades, because a few
  /// elements at the edges of contact dissipate a hundred times the power of a free surface.
  float position(double value) const;
  /// Returns the value above which points are coloured.
  double minimumShown() const;
  Rgba colour(double value) const { return colourAt(position(value)); }
  Rgba colourAt(float position) const;
  /// Returns the quantity with the unit of the ticks.
  std::string title() const;
  std::string shortTitle() const;  // where the full title does not fit
  /// Returns ticks at both ends, and between them round values or, for power, decades. `hasUnit`:
  /// the last one has the unit, where there is no title.
  std::vector<ColourTick> ticks(int most, bool hasUnit) const;
};

/// Returns a few words on why the frame has nothing to colour; empty where it has, or where this is
/// unknown because the frame lacks the values.
std::string reasonUncoloured(const Frame& frame, ContactOverlay overlay);

/// Returns the values of the scale at the frame's points; empty where the frame lacks them.
const std::vector<double>& overlayValues(const Frame& frame, ContactOverlay overlay);

/// Returns a round maximum of the scale for this frame, 0 where it has no values or where the
/// pressures of its points are not those of the contact (`pointsBearLoad`). `last` is kept as long
/// as it fits; for pressures only where those of the steady state are unknown.
double scaleMaximum(const Frame& frame, ContactOverlay overlay, double last);

/// Returns the maximum of the colour scale in a view.
double colourMaximum(const ContactView& view, ContactOverlay overlay);
/// Sets it; a view without an overlay has none.
void setColourMaximum(ContactView& view, ContactOverlay overlay, double maximum);

}  // namespace asperity
