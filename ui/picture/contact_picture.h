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
const Theme& printTheme();  // black on white, for paper

/// The part of the world that is shown. Metres; heights as in Frame.
struct ContactView {
  double left = 0, width = 0;  // 0 width: the whole period
  double bottom = 0, top = 0;  // equal: fitted to the frame, and steady while it slides
  double pressure = 0;         // N/m, bright end of the colour scale; 0: fitted to the frame

  bool operator==(const ContactView&) const = default;
};

struct ContactPictureOptions {
  int width = 1280, height = 720;  // pixels
  float scale = 1;                 // of fonts and line widths; 2 on a high-density screen
  Theme theme = lightTheme();
  ContactView view;
  bool title = true;  // scene title and readings above the axes
};

/// A view that fits the frame and moves only when it must (call with the last view to avoid
/// jitter). Heights and pressure are fitted to the whole period, so they stand still while the line
/// slides by; left and width are those of `last` (0 and 0 without one: the whole period).
ContactView fittedView(const Frame& frame, const std::optional<ContactView>& last = {});

/// The same view with every 0 that stands for a default replaced by its value. The pressure stays 0
/// where none is known: the frame has none and the view names none.
ContactView resolvedView(const Frame& frame, const ContactView& view);

/// Where composeContact puts the axes' rectangle: the view's left, width, bottom and top fill it.
Clip contactPlotArea(const Frame& frame, const ContactPictureOptions& options);

/// Shapes and texts. A frame without points gives empty axes; never throws for what a frame holds.
/// At most two vertices a pixel column and curve, so the cost does not grow with the points.
DrawList composeContact(const Frame& frame, const ContactPictureOptions& options);

}  // namespace asperity
