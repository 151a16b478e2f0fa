// Where the parts of a contact picture go, and the way from metres to pixels. Private to
// ui/picture. Plain values; any thread.
#pragma once

#include "ui/picture/contact_overlay.h"
#include "ui/picture/contact_picture.h"
#include "ui/picture/shapes.h"
#include "ui/picture/ticks.h"

namespace asperity {

/// Sizes in pixels; whole numbers for fonts, as the painter knows no others.
struct Sizes {
  float unit = 1;  // of line widths and distances
  float title = 18, body = 13, small = 11;
};
Sizes sizesFor(const ContactPictureOptions& options);

struct ContactLayout {
  int width = 0, height = 0;
  Sizes sizes;
  Theme theme;
  ContactView view;  // resolved
  Box plot;
  AxisTicks xTicks, heightTicks;
  ColourScale scale;
  bool axisTitles = true;
  Box legend;        // the colour bar; no width: no room for one, or nothing coloured
  float footer = 0;  // baseline of the footer's text; 0: none
  float footerWidth = 0;
  std::optional<std::size_t> marked;  // point of a contact so narrow that a dot has to show it

  double pixelsPerMetreAlong() const;
  double pixelsPerMetreUp() const;
  float px(double x) const;
  float py(double metres) const;  // heights as in Frame
};

/// `headerBottom`: pixels taken by the title and readings.
ContactLayout layoutContact(const Frame& frame, const ContactPictureOptions& options,
                            float headerBottom);

std::string exaggerationText(const ContactLayout& layout);

}  // namespace asperity
