// The contact as a picture, in the style of Fig. 1 of Li et al. (2013): the rigid line above, the
// deformed elastomer filled below, contacts coloured by pressure or the surface by another
// quantity, forces as arrows, axes with units, the vertical exaggeration as text. Pure functions of
// their arguments; the same picture in the window, headless and in the tests. Any thread.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/run/frame.h"
#include "ui/draw/draw_list.h"
#include "ui/draw/theme.h"

namespace asperity {

/// The visible part of the contact. Metres; heights as in Frame.
struct ContactView {
  double left = 0, width = 0;  // width 0: the whole period
  double bottom = 0, top = 0;  // equal: fitted to the frame, and fixed while it slides
  double pressure = 0;         // N/m, maximum of the colour scale; 0: fitted to the frame
  double age = 0;              // s since contact, the same for that scale
  double power = 0;            // W/m, the same for that scale

  bool operator==(const ContactView&) const = default;
};

/// The quantity that the colours of the elastomer's surface show.
enum class ContactOverlay {
  None,
  Pressure,
  Relaxation,  // time since contact (Frame::sinceContact)
  Power        // dissipated power (Frame::power)
};

/// A part of the contact enlarged in an inset.
struct Magnifier {
  double position = 0;     // m, of its middle
  double enlargement = 8;  // of x, relative to the picture around it

  bool operator==(const Magnifier&) const = default;
};

/// The position of a label of the last picture, by the id of its explanation.
struct LabelPlace {
  std::string_view id;
  float left = 0;  // pixel
};

struct ContactPictureOptions {
  int width = 1280, height = 720;  // pixels
  float scale = 1;                 // of fonts and line widths; 2 on a high-density screen
  Theme theme = lightTheme();
  ContactView view;
  bool title = true;  // scene title and readings above the axes
  bool names = true;  // of the bodies, in the plot, with the arrows of the forces
  ContactOverlay overlay = ContactOverlay::Pressure;
  std::optional<double> probe;  // m: position of a crosshair with readings of that element
  std::optional<Magnifier> magnifier;
  float fontSize = 0;   // pixels, of the tick labels; 0: automatic
  float lineWidth = 0;  // pixels, of line and surface; 0: automatic
  float plotLeft = 0;   // pixels, least left edge of the axes, as that of a chart below
  /// Labels that give way to the line of a low picture stay here as long as it does not cross them.
  std::vector<LabelPlace> lastLabels{};
};

/// Returns a view that fits the frame and changes only when it must (pass the last view to avoid
/// jitter). Heights and colours are fitted to the whole period, so they stay fixed while the line
/// slides by; left and width are those of `last` (0 and 0 without one: the whole period).
/// labelSpace: at least this part of the plot's height is above the line, whatever passes by.
ContactView fittedView(const Frame& frame, const std::optional<ContactView>& last = {},
                       double labelSpace = 0);

/// Fits the heights of a view to the part of the line that it shows, for a picture that stands
/// still.
void fitToPart(const Frame& frame, ContactView& view);

/// Returns the part of the plot's height that the row of labels needs above the line, so that none
/// of them has to give way to a summit; 0 where the plot is so low that it would take too much.
double labelSpace(const Frame& frame, const ContactPictureOptions& options);

/// Returns the view with every 0 for a default replaced by its value. A maximum of a colour scale
/// stays 0 where it is unknown: the frame has no such values and the view gives none.
ContactView resolvedView(const Frame& frame, const ContactView& view);

/// Returns the rectangle of the axes in composeContact; it shows the view's left, width, bottom and
/// top.
Box contactPlotArea(const Frame& frame, const ContactPictureOptions& options);
/// Returns the unit of line widths and distances, in pixels; its small texts are 12 units high.
float contactUnit(const ContactPictureOptions& options);

/// Part of a picture's height for the contact above one diagram, and above two.
inline constexpr double kContactPart = 0.54, kContactPartOfThree = 0.4;

/// Draws shapes and texts. A frame without points gives empty axes; it never throws because of a
/// frame's content. Each curve has at most two vertices per pixel column, so the cost does not grow
/// with the points. places: receives where the labels are, for the next picture of the same size;
/// may be null.
DrawList composeContact(const Frame& frame, const ContactPictureOptions& options,
                        std::vector<LabelPlace>* places = nullptr);

}  // namespace asperity
