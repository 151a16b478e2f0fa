// A diagram with logarithmic axes as a plain value: what to show, without saying with which widget.
// Composed by friction_plot.h, shown by plot_view.h. Copied freely; any thread.
#pragma once

#include <QString>
#include <limits>
#include <optional>
#include <vector>

namespace asperity {

/// Decimal logarithms of the ends of an axis, whole numbers but for zoomed ones; empty where to <=
/// from.
struct DecadeRange {
  double from = 0, to = 0;

  bool isEmpty() const { return to <= from; }
  double size() const { return to - from; }
  bool operator==(const DecadeRange&) const = default;
};

/// What is shown of a plot.
struct PlotWindow {
  DecadeRange x, y;

  bool operator==(const PlotWindow&) const = default;
};

struct PlotPoint {
  double x = 0, y = 0;
  double error = std::numeric_limits<double>::quiet_NaN();  // half an error bar; NaN: none
  int row = -1;                                             // of the curve's table

  bool operator==(const PlotPoint&) const = default;
};

/// Whether a point has a place on logarithmic axes: both coordinates finite and positive.
bool isPlottable(double x, double y);

/// The points that have a place, in their order.
std::vector<PlotPoint> plottable(const std::vector<PlotPoint>& points);

enum class PlotStyle { Points, Line };
enum class PlotMark { Circle, Square, Triangle, Diamond };

/// Numbers of the series that are not pinned curves, whose own are above 0; and of the strip.
inline constexpr int kPresentCurve = 0, kLawCurve = -1, kStripCurve = -2;

struct PlotSeries {
  QString name;  // for the legend
  PlotStyle style = PlotStyle::Points;
  bool faded = false;  // belongs to an older scene
  std::vector<PlotPoint> points;
  int id = kPresentCurve;
  int place = -1;  // of a pinned curve: decides its colour
  PlotMark mark = PlotMark::Circle;

  bool isPinned() const { return id > 0; }
  bool operator==(const PlotSeries&) const = default;
};

/// A range along x that has a name.
struct PlotSpan {
  QString name, word;  // "III", "plateau"
  QString tip;         // a sentence or two
  double from = 0, to = 0;
  bool faded = false;

  bool operator==(const PlotSpan&) const = default;
};

/// A vertical line at x, with a dot at y where y has a place, and the way that it came.
struct PlotMarker {
  QString name;   // for the legend
  QString label;  // beside the line
  double x = 0;
  double y = std::numeric_limits<double>::quiet_NaN();
  bool isFixed = false;            // moves by itself, not by hand
  std::vector<PlotPoint> trace{};  // in its order; interrupted where a point has no place
  bool faded = false;              // of an older scene
};

struct PlotAxis {
  QString title;
  QString shortTitle;  // where there is no room for it
  DecadeRange range;

  bool operator==(const PlotAxis&) const = default;
};

/// A slim plot below, over the same x, with a linear axis.
struct PlotStrip {
  QString title;  // "difference (%)"
  QString name;   // whose: "linear x4, 20 lines, less the curve above"
  QString note;   // how far it is
  double from = 0, to = 0;
  bool faded = false;
  std::vector<PlotPoint> points;  // what lies beyond the range stands at its edge

  bool operator==(const PlotStrip&) const = default;
};

struct Plot {
  PlotAxis x, y;
  std::vector<PlotSeries> series;
  std::vector<PlotSpan> spans;     // shaded by turns, named above
  std::vector<PlotSpan> shades{};  // tinted over the spans, named at their feet
  std::optional<PlotMarker> marker;
  std::optional<PlotStrip> strip;
  QString note;         // how far it is: "37 of 200 realizations"
  double progress = 0;  // 0 to 1, of the present curve; shown elsewhere
  QString blank;        // in the middle: why there is nothing to see
};

}  // namespace asperity
