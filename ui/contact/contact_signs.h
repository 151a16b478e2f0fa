// The texts of a contact picture under the pointer: readings, labels with their arrows, axes, the
// legend of the colours, the notes below the axes, each with its box and its explanation. What can
// be dragged is a handle: the rigid body sets the load (depth, force or pressure), the arrow of the
// force sets the normal force or the pressure, the arrow of the velocity the velocity. Pure
// functions; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "ui/contact/contact_picture.h"

namespace asperity {

enum class ContactHandle { None, Body, Force, Velocity };

struct ContactSign {
  Box box;              // pixels
  std::string name;     // as it is written
  std::string_view id;  // of core/chart/explanations.h; empty: the tip is complete
  std::string tip{};    // a sentence on this frame; empty: that of the explanation
  ContactHandle handle = ContactHandle::None;  // what a drag of it changes
};

/// Returns the readings above the axes, each with a sentence about it. A title that does not fit
/// its line is the first one, with its full text as the sentence and no explanation.
std::vector<ContactSign> contactReadings(const Frame& frame, const ContactPictureOptions& options);

/// Returns all signs of the picture that composeContact makes, first the readings.
std::vector<ContactSign> contactSigns(const Frame& frame, const ContactPictureOptions& options);

/// Returns the sign under a pixel.
std::optional<ContactSign> contactSignAt(const Frame& frame, const ContactPictureOptions& options,
                                         float x, float y);

/// Returns the labels of a picture that can be dragged.
std::vector<ContactSign> contactHandles(const Frame& frame, const ContactPictureOptions& options);

/// Returns the handle under a pixel of the picture. The body is the area on the line and above it.
ContactHandle handleAt(const Frame& frame, const ContactPictureOptions& options, float x, float y);

/// Returns the key that a drag changes: the body that of the load's kind, the force's arrow the
/// force or the pressure. Empty where it changes nothing: a given indentation leaves no force to
/// choose.
std::string_view draggedKey(ContactHandle handle, const Scene& scene);

/// The distance that the pointer has moved since the button was pressed.
struct DragDistance {
  double right = 0, down = 0;  // parts of the plot's width and height
  double height = 0;           // m, heights that the plot showed at the beginning
};

/// Returns the scene with the value that a drag gives it. An indentation changes by the height that
/// the pointer moved, so that the body stays under it; a force changes by two decades over the
/// plot's height, downwards to more; a velocity by four decades over the plot's width, in the
/// direction of sliding to more. Values have four digits and stay within what the key allows.
Scene dragged(const Scene& start, ContactHandle handle, const DragDistance& moved);

}  // namespace asperity
