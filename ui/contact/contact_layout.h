// The layout of a contact picture, and the map from metres to pixels. Private to ui/contact. Plain
// values; any thread.
#pragma once

#include "ui/contact/contact_overlay.h"
#include "ui/contact/contact_picture.h"
#include "ui/draw/shapes.h"
#include "ui/draw/ticks.h"

namespace asperity {

/// Sizes in pixels; whole numbers for fonts, because the painter knows no others.
struct Sizes {
  float unit = 1;  // of line widths and distances
  float title = 18, body = 13, small = 11;
  float curve = 1.7F;  // width of line and surface, pixels

  /// Returns the height of the labels inside the axes.
  float labelHeight() const;
};
Sizes sizesFor(const ContactPictureOptions& options);

inline constexpr float kNumberGap = 6;  // units, from a legend's bar to a number beside it

/// The legend of the colours: a title, a bar, and numbers below it or, in a low picture, beside it
/// in one line.
struct LegendLayout {
  Box bar;              // width 0: nothing is coloured, or there is no space
  bool inLine = false;  // the numbers are beside the bar
  std::string title;    // or why nothing is coloured; may be empty
  DrawPoint titleEnd;   // right end of its baseline
};

struct ContactLayout {
  int width = 0, height = 0;
  Sizes sizes;
  Theme theme;
  ContactView view;  // resolved
  Box plot;
  AxisTicks xTicks, heightTicks;
  ColourScale scale;
  bool axisTitles = true;
  DrawPoint axisTitle;  // of the x-axis: middle of its baseline
  LegendLayout legend;
  float footer = 0;  // baseline of the footer's text; 0: none
  float footerWidth = 0;
  std::optional<std::size_t> marked;  // point of a contact so narrow that a dot must show it
  std::vector<LabelPlace> lastLabels{};
  std::vector<Box> covered{};  // boxes of the inset and of the readout, in which labels are hidden

  double pixelsPerMetreX() const;
  double pixelsPerMetreY() const;
  float px(double x) const;
  float py(double metres) const;  // heights as in Frame
  /// Returns the left end of a label in the last picture; none where it had none.
  std::optional<float> lastPlace(std::string_view id) const;
};

/// Makes the layout. `headerBottom`: pixels taken by the title and readings.
ContactLayout layoutContact(const Frame& frame, const ContactPictureOptions& options,
                            float headerBottom);

/// Returns "position (mm)".
std::string xAxisTitle(const ContactLayout& layout);
std::string exaggerationText(const ContactLayout& layout);

}  // namespace asperity
