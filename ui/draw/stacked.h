// Pictures put together from others. Pure; any thread.
#pragma once

#include "ui/draw/draw_list.h"

namespace asperity {

/// Of the height, for a contact above a diagram, and above one with a second panel under it.
inline constexpr double kContactPart = 0.54;
inline constexpr double kContactPartOfThree = 0.4;

/// All of `part`, with its background, this far right and down on `list`.
void addPicture(DrawList& list, DrawList part, float right, float down);

/// One above the other; as wide as the wider one.
DrawList stacked(DrawList above, DrawList below);

}  // namespace asperity
