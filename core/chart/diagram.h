// A diagram as a plain value: the content of a chart, without its drawing. It is the only model of
// every chart: core makes it beside the data, ui/chart/diagram_picture.h composes it as a picture,
// ui/chart/chart_view.h shows it interactively. Copied freely; any thread. All values are SI; an
// axis with a unit shows its numbers with a suitable prefix if it is linear, and as powers of ten
// if it is logarithmic. Texts are English templates with their values, which ui/language
// translates.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/message.h"
#include "core/base/statistics.h"

namespace asperity {

enum class AxisScale { Linear, Logarithmic };

/// The scales by their names in options and files.
inline constexpr std::array<std::pair<std::string_view, AxisScale>, 2> kAxisScales{
    {{"log", AxisScale::Logarithmic}, {"linear", AxisScale::Linear}}};

/// Returns the position of a value on an axis: the value itself or its decimal logarithm; NaN where
/// the axis cannot show it.
inline double axisPosition(AxisScale scale, double value) {
  const bool isShown = std::isfinite(value) && (scale == AxisScale::Linear || value > 0);
  if (!isShown) return kNaN;
  return scale == AxisScale::Linear ? value : std::log10(value);
}
/// Returns whether a value lies below every position of a logarithmic axis. A line through its
/// point runs to the lower end of the axis.
inline bool isBelow(AxisScale scale, double value) {
  return scale == AxisScale::Logarithmic && std::isfinite(value) && value <= 0;
}
/// Returns the value at a position on the axis.
inline double axisValue(AxisScale scale, double position) {
  return scale == AxisScale::Logarithmic ? std::pow(10, position) : position;
}

/// Factor between the outermost values and the ends of a logarithmic axis.
inline constexpr double kLogMargin = 1.3;

struct DiagramAxis {
  Message title{};     // "sliding velocity"
  std::string unit{};  // "m/s"; empty: a pure number
  AxisScale scale = AxisScale::Logarithmic;
  double from = 0, to = 0;  // equal: automatic
  bool isOfNames = false;   // positions have names above the frame instead of numbers; no ticks
};

/// A point. One without a position on the axes (not finite, or not positive on a logarithmic axis)
/// is not drawn and interrupts the line, unless its y is below the axis.
struct DiagramPoint {
  double x = 0, y = 0;
  double low = kNaN;   // of the error bar or band; NaN: none
  double high = kNaN;  // the same
  int row = -1;        // row of the table with the point's values; -1: none

  bool operator==(const DiagramPoint&) const = default;
};

/// Returns a point with a bar of this error to each side; NaN: without one.
inline DiagramPoint pointWithError(double x, double y, double error, int row = -1) {
  return {x, y, y - error, y + error, row};
}

/// A ring is open and larger than the others, because it encloses one of them.
enum class SeriesMark { None, Circle, Square, Triangle, Diamond, Ring };
enum class SeriesStroke { None, Solid, Dashed, Dotted };

struct DiagramSeries {
  Message name{};  // for the legend; empty: not in it
  SeriesMark mark = SeriesMark::None;
  SeriesStroke stroke = SeriesStroke::Solid;
  bool isBand = false;    // low to high as a filled band instead of error bars
  bool isTheory = false;  // in the colour of text, thinner, under the data
  int colour = -1;        // index in the palette of distinct colours; -1: the next one
  /// Position on the colour ramp, 0 to 1, instead of a distinct colour; NaN: not on the ramp.
  double ramp = kNaN;
  std::vector<DiagramPoint> points{};
  int id = -1;                         // identifies the series under the pointer; -1: none
  bool isFaded = false;                // belongs to an earlier state
  std::optional<std::uint32_t> rgb{};  // 0xRRGGBB, instead of a palette's colour

  /// Leaves the points without error bars.
  void dropErrors() {
    for (DiagramPoint& point : points) point.low = point.high = DiagramPoint{}.low;
  }
};

/// A named range in x ("I transition", "zone 1").
struct DiagramSpan {
  double from = 0, to = 0;
  Message label{};
  std::string shortLabel{};      // "I": used where the label does not fit
  std::vector<Message> notes{};  // information for the user's pointer at its name
  bool isFaded = false;          // belongs to an earlier state
};

/// A vertical line at x with a dot at y if the axis can show y: the present state on a curve of
/// possible states. The user can drag it in the window.
struct DiagramMarker {
  Message name{};   // for the legend
  Message label{};  // beside the line: "v = 1 m/s"
  double x = 0;
  double y = kNaN;
  bool isFixed = false;               // moves by itself and cannot be dragged
  bool isFaded = false;               // belongs to an earlier state
  std::vector<DiagramPoint> trace{};  // its earlier states; one without a position interrupts it
  bool isCross = false;               // with a horizontal line at y, too
};

/// A text at a point, with an arrow from (x, y) to (arrowX, arrowY) where these are given.
struct DiagramLabel {
  Message text{};
  double x = 0, y = 0;
  double arrowX = kNaN;
  double arrowY = kNaN;
};

/// The meaning of a colour ramp; it replaces the legend entries of its series.
struct DiagramRamp {
  Message title{};   // "normal force"
  Message from, to;  // "1 mN", "100 N"
};

/// A line along which a field has one value.
struct DiagramContour {
  double value = 0;
  Message label{};                                 // on the line: "0.02"
  std::vector<std::vector<DiagramPoint>> lines{};  // of x and y alone
};

/// A quantity over the plane of the axes, as colours under everything else, with a colour bar.
struct DiagramField {
  DiagramAxis colours{};         // title, unit, scale and range of the quantity
  std::vector<double> x{}, y{};  // positions of the grid's columns and rows, rising on their axes
  std::vector<double> values{};  // x fastest; NaN: not known, and left blank
  std::vector<DiagramContour> contours{};
};

/// A horizontal bar from 0 with its name in place of a tick; the first one is at the top.
struct DiagramBar {
  Message name{};
  double value = 0;
  double error = kNaN;  // to each side of its end; NaN: none

  /// Returns whether the value is larger than its error; true where the error is unknown.
  bool isSignificant() const { return !std::isfinite(error) || std::abs(value) > error; }
};

struct Diagram {
  Message title{};  // over this diagram; may be empty
  DiagramAxis x{}, y{};
  std::vector<DiagramSeries> series{};  // later ones over earlier ones
  std::vector<DiagramSpan> spans{};     // every second one is shaded, names are above the frame
  std::vector<DiagramLabel> labels{};
  std::optional<DiagramRamp> ramp{};
  double height = 1;                  // relative height of its row in a sheet with one column
  std::vector<DiagramSpan> shades{};  // tinted over the spans, named inside the frame at its foot
  std::optional<DiagramMarker> marker{};
  Message blank{};  // why there is no curve, in the middle of the frame
  std::optional<DiagramField> field{};
  std::vector<DiagramBar> bars{};  // instead of the y-axis
};

/// Returns whether the axes of the diagram can show the point.
inline bool hasPosition(const Diagram& diagram, const DiagramPoint& point) {
  return std::isfinite(axisPosition(diagram.x.scale, point.x)) &&
         std::isfinite(axisPosition(diagram.y.scale, point.y));
}

/// Diagrams side by side under one heading.
struct DiagramSheet {
  Message title{};     // "Fig. 3: six Hurst exponents"
  Message subtitle{};  // the parameters, one line
  Message note{};      // small text below: information for the reader
  std::vector<Diagram> diagrams{};
  int columns = 0;          // diagrams in a row; 0: up to three in one row, more in a square
  bool sharesAxis = false;  // of one column: all share the x-axis and are aligned
  bool isGrowing = false;   // more results follow: a view should not change its layout meanwhile
  Message status{};         // of work in progress: "37 of 200 realizations"; not in pictures
};

struct NamedSheet {
  std::string name;  // of its file: "master_curve"
  DiagramSheet sheet;
};

}  // namespace asperity
