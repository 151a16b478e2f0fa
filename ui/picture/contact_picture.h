// The contact as a picture, in the manner of Fig. 1 of Li et al. (2013): the rigid line above, the
// deformed elastomer filled below, contacts coloured by pressure, axes with units, the vertical
// exaggeration stated. Pure functions of their arguments; the same picture in the window, headless
// and in the tests. Any thread.
#pragma once

#include <optional>

#include "core/run/frame.h"
#include "ui/render/draw_list.h"

namespace asperity {

struct Theme {
  Rgba background, panel, text, faintText, grid, axis;
  Rgba rigid, rigidEdge, elastomer, elastomerEdge, highlight;
};
const Theme& lightTheme();
const Theme& darkTheme();

/// The part of the world that is shown. Metres; heights as in Frame.
struct ContactView {
  double left = 0, width = 0;  // 0 width: the whole period
  double bottom = 0, top = 0;  // equal: fitted to the frame, and steady while it slides
};

struct ContactPictureOptions {
  int width = 1280, height = 720;  // pixels
  float scale = 1;                 // of fonts and line widths; 2 on a high-density screen
  Theme theme = lightTheme();
  ContactView view;
  bool title = true;               // scene title and readings above the axes
};

/// A view that fits the frame and moves only when it must (call with the last view to avoid jitter).
ContactView fittedView(const Frame& frame, const std::optional<ContactView>& last = {});

DrawList composeContact(const Frame& frame, const ContactPictureOptions& options);

}  // namespace asperity
