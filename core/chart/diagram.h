// A diagram as a plain value: what a chart has to show, without saying how it is drawn. The one
// model of every chart: made by core beside the data that it shows, composed as a picture by
// ui/chart/diagram_picture.h, shown to a user who points into it by ui/chart/chart_view.h.
// Copied freely; any thread.
// All values are SI; an axis with a unit shows its numbers with a fitting prefix where it is
// linear, and as powers of ten where it is logarithmic. Texts are English templates with their
// values, which ui/language translates.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"

namespace asperity {

enum class AxisScale { Linear, Logarithmic };

struct DiagramAxis {
  Message title{};     // "sliding velocity"
  std::string unit{};  // "m/s"; empty: a pure number
  AxisScale scale = AxisScale::Logarithmic;
  double from = 0, to = 0;  // equal: as the points need
};

/// What has no place (not finite, or not positive on a logarithmic axis) is not drawn and breaks
/// the line.
struct DiagramPoint {
  double x = 0, y = 0;
  double low = std::numeric_limits<double>::quiet_NaN();   // of the error bar or band; NaN: none
  double high = std::numeric_limits<double>::quiet_NaN();  // the same
  int row = -1;  // of the table that the point can be read from; -1: of none

  bool operator==(const DiagramPoint&) const = default;
};

/// A ring is open and larger than the others, to stand around one of them.
enum class SeriesMark { None, Circle, Square, Triangle, Diamond, Ring };
enum class SeriesStroke { None, Solid, Dashed, Dotted };

struct DiagramSeries {
  Message name{};  // for the legend; empty: not in it
  SeriesMark mark = SeriesMark::None;
  SeriesStroke stroke = SeriesStroke::Solid;
  bool isBand = false;    // low to high as a filled band instead of error bars
  bool isTheory = false;  // drawn in the colour of text, thinner, under the data
  int colour = -1;        // of the palette's distinct colours, in order; -1: the next one
  /// Place on the colour ramp, 0 to 1, instead of a distinct colour; NaN: not on the ramp.
  double ramp = std::numeric_limits<double>::quiet_NaN();
  std::vector<DiagramPoint> points{};
  int id = -1;           // tells its maker which series somebody points at; -1: none
  bool isFaded = false;  // belongs to a state that is over
};

/// A range along x that has a name ("I transition", "zone 1").
struct DiagramSpan {
  double from = 0, to = 0;
  Message label{};
  std::string shortLabel{};      // "I": where the label has no room
  std::vector<Message> notes{};  // what to know of it, for a user who points at its name
  bool isFaded = false;          // belongs to a state that is over
};

/// A vertical line at x with a dot at y where y has a place: what is so now, on a curve of what may
/// be. A user can drag it in the window.
struct DiagramMarker {
  Message name{};   // for the legend
  Message label{};  // beside the line: "v = 1 m/s"
  double x = 0;
  double y = std::numeric_limits<double>::quiet_NaN();
  bool isFixed = false;               // moves by itself and is not dragged
  bool isFaded = false;               // belongs to a state that is over
  std::vector<DiagramPoint> trace{};  // the way it came; breaks where a point has no place
};

/// A text at a point, with an arrow from (x, y) to (arrowX, arrowY) where these are given.
struct DiagramLabel {
  Message text{};
  double x = 0, y = 0;
  double arrowX = std::numeric_limits<double>::quiet_NaN();
  double arrowY = std::numeric_limits<double>::quiet_NaN();
};

/// What the colours of a ramp mean; shown instead of a legend entry for each of its series.
struct DiagramRamp {
  Message title{};   // "normal force"
  Message from, to;  // "1 mN", "100 N"
};

struct Diagram {
  Message title{};  // over this diagram; may be empty
  DiagramAxis x, y;
  std::vector<DiagramSeries> series;  // later ones over earlier ones
  std::vector<DiagramSpan> spans;     // shaded by turns, named above the frame
  std::vector<DiagramLabel> labels;
  std::optional<DiagramRamp> ramp;
  double height = 1;                  // of its row among rows, where a sheet has one column
  std::vector<DiagramSpan> shades{};  // tinted over the spans, named inside the frame at its foot
  std::optional<DiagramMarker> marker{};
  Message blank{};  // in the middle of the frame: why nothing is to be seen
};

/// Diagrams side by side under one heading.
struct DiagramSheet {
  Message title{};     // "Fig. 3: six Hurst exponents"
  Message subtitle{};  // the parameters, one line
  Message note{};      // below, small: what to know when reading it
  std::vector<Diagram> diagrams;
  int columns = 0;          // diagrams in a row; 0: up to three in one row, more in a square
  bool sharesAxis = false;  // of one column: all have one axis along and stand in one line
  Message status{};         // of work in progress: "37 of 200 realizations"; not in pictures
};

}  // namespace asperity
