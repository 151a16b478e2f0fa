// A diagram with logarithmic axes as a plain value: what to show, without saying with which widget.
// Composed by friction_plot.h, shown by plot_view.h. Copied freely; any thread.
#pragma once

#include <QString>
#include <limits>
#include <optional>
#include <vector>

namespace asperity {

/// Whole decades, 10^from to 10^to; empty where to <= from.
struct DecadeRange {
  int from = 0, to = 0;

  bool isEmpty() const { return to <= from; }
  bool operator==(const DecadeRange&) const = default;
};

struct PlotPoint {
  double x = 0, y = 0;
  double error = std::numeric_limits<double>::quiet_NaN();  // half an error bar; NaN: none

  bool operator==(const PlotPoint&) const = default;
};

/// Whether a point has a place on logarithmic axes: both coordinates finite and positive.
bool isPlottable(double x, double y);

/// The points that have a place, in their order.
std::vector<PlotPoint> plottable(const std::vector<PlotPoint>& points);

enum class PlotStyle { Points, Line };

struct PlotSeries {
  QString name;  // for the legend
  PlotStyle style = PlotStyle::Points;
  bool faded = false;  // belongs to an older scene
  std::vector<PlotPoint> points;

  bool operator==(const PlotSeries&) const = default;
};

/// A vertical line at x, with a dot at y where y has a place.
struct PlotMarker {
  QString name;   // for the legend
  QString label;  // beside the line
  double x = 0;
  double y = std::numeric_limits<double>::quiet_NaN();
};

struct PlotAxis {
  QString title;
  DecadeRange range;

  bool operator==(const PlotAxis&) const = default;
};

struct Plot {
  PlotAxis x, y;
  std::vector<PlotSeries> series;
  std::optional<PlotMarker> marker;
  QString note;         // how far it is: "37 of 200 realizations"
  double progress = 0;  // 0 to 1, beside the note
  QString blank;        // in the middle: why there is nothing to see
};

}  // namespace asperity
