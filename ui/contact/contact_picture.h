// The contact as a picture, in the manner of Fig. 1 of Li et al. (2013): the rigid line above, the
// deformed elastomer filled below, contacts coloured by pressure or the surface by what else is
// asked for, forces as arrows, axes with units, the vertical exaggeration stated. Pure functions of
// their arguments; the same picture in the window, headless and in the tests. Any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/run/frame.h"
#include "ui/draw/draw_list.h"
#include "ui/draw/theme.h"

namespace asperity {

/// The part of the world that is shown. Metres; heights as in Frame.
struct ContactView {
  double left = 0, width = 0;  // 0 width: the whole period
  double bottom = 0, top = 0;  // equal: fitted to the frame, and steady while it slides
  double pressure = 0;         // N/m, bright end of the colour scale; 0: fitted to the frame
  double age = 0;              // s since contact, likewise
  double power = 0;            // W/m, likewise

  bool operator==(const ContactView&) const = default;
};

/// What the colours on the elastomer's surface say.
enum class ContactOverlay {
  None,
  Pressure,
  Relaxation,  // time since contact (Frame::sinceContact)
  Power        // dissipated (Frame::power)
};

/// A part of the contact enlarged in an inset.
struct Magnifier {
  double position = 0;     // m, in its middle
  double enlargement = 8;  // of lengths along, against the picture around it

  bool operator==(const Magnifier&) const = default;
};

struct ContactPictureOptions {
  int width = 1280, height = 720;  // pixels
  float scale = 1;                 // of fonts and line widths; 2 on a high-density screen
  Theme theme = lightTheme();
  ContactView view;
  bool title = true;  // scene title and readings above the axes
  ContactOverlay overlay = ContactOverlay::Pressure;
  std::optional<double> probe;  // m: a crosshair there, and what is to be read at that element
  std::optional<Magnifier> magnifier;
};

/// A view that fits the frame and moves only when it must (call with the last view to avoid
/// jitter). Heights and colours are fitted to the whole period, so they stand still while the line
/// slides by; left and width are those of `last` (0 and 0 without one: the whole period).
ContactView fittedView(const Frame& frame, const std::optional<ContactView>& last = {});

/// The same view with every 0 that stands for a default replaced by its value. An end of a colour
/// scale stays 0 where none is known: the frame has no such values and the view names none.
ContactView resolvedView(const Frame& frame, const ContactView& view);

/// Where composeContact puts the axes' rectangle: the view's left, width, bottom and top fill it.
Clip contactPlotArea(const Frame& frame, const ContactPictureOptions& options);
/// Pixels, of line widths and distances in it; its small texts are 12 of them high.
float contactUnit(const ContactPictureOptions& options);

/// A reading above the axes: where it stands (pixels), what it is called, and a sentence on it. A
/// title that does not fit its line is the first, with all of it for the sentence.
struct ContactReading {
  Clip place;
  std::string name, tip;
};
std::vector<ContactReading> contactReadings(const Frame& frame,
                                            const ContactPictureOptions& options);

/// Shapes and texts. A frame without points gives empty axes; never throws for what a frame holds.
/// At most two vertices a pixel column and curve, so the cost does not grow with the points.
DrawList composeContact(const Frame& frame, const ContactPictureOptions& options);

}  // namespace asperity
