// The colours of a picture: of its ground, its texts and axes, and of the two bodies in contact.
// Constant values; any thread.
#pragma once

#include "ui/draw/draw_list.h"

namespace asperity {

struct Theme {
  Rgba background, panel, text, faintText, grid, axis;
  Rgba rigid, rigidEdge, elastomer, elastomerEdge, highlight;
};
const Theme& lightTheme();
const Theme& darkTheme();
const Theme& printTheme();  // black on white, for paper

}  // namespace asperity
