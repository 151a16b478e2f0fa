// The axes of a diagram: their ranges, their ticks and titles, and the way from values to pixels.
// Private to ui/chart. Pure; any thread. Pixels, y down.
#pragma once

#include <string>
#include <vector>

#include "core/chart/diagram.h"
#include "ui/chart/diagram_layout.h"
#include "ui/draw/shapes.h"
#include "ui/draw/theme.h"

namespace asperity {

/// In an axis' own measure: decimal logarithms on a logarithmic one.
struct AxisRange {
  double from = 0, to = 0;

  bool isEmpty() const { return to <= from; }
  double size() const { return to - from; }
  bool operator==(const AxisRange&) const = default;
};

/// The value itself or its decimal logarithm; NaN where it has no place on the axis.
double axisPlace(AxisScale scale, double value);

/// As the axis says, otherwise as the data need; theory counts where there are no data.
AxisRange rangeAlong(const Diagram& diagram);
/// Of the points inside the range along x; theory lines widen it a little.
AxisRange rangeUp(const Diagram& diagram, const AxisRange& along);

struct AxisTick {
  double value = 0;  // in the axis' own measure
  std::string label;
};

/// An axis with as many ticks as its length has room for.
struct TickedAxis {
  AxisScale scale = AxisScale::Linear;
  AxisRange range{0, 1};
  std::vector<AxisTick> ticks;
  std::vector<double> minor;  // between the ticks
  std::string title;          // "velocity v (mm/s)"; the prefix is that of the ticks
};
TickedAxis tickedAlong(const DiagramAxis& axis, const AxisRange& range, float pixels,
                       const DiagramSizes& sizes);
TickedAxis tickedUp(const DiagramAxis& axis, const AxisRange& range, float pixels,
                    const DiagramSizes& sizes);

/// A title in the largest of some sizes in which it fits.
struct FittedTitle {
  std::string text;
  float size = 12;
};
/// Words go first, then all but the symbol and the unit; the unit with its power of ten never, as
/// the numbers on the axis would be wrong without it.
FittedTitle fittedTitle(const std::string& title, float size, float pixels);

/// The frame of a diagram and its axes.
struct DiagramAxes {
  Box box;
  TickedAxis along, up;
  bool saysAlong = true;    // false: labels and title stand under another frame below
  bool titleAbove = false;  // the title of the axis up lies over the frame, not upright beside it

  /// From a place in an axis' own measure.
  float px(double x) const;
  float py(double y) const;
  /// In pixels, at most 1e6 from the origin; NaN where a value has no place.
  Place place(double x, double y) const;
};

/// Pixels left of the frame for title and labels, below it where it says what is along, and above
/// it where the title of the axis up stands there.
float leftOfAxes(const DiagramAxes& axes, const DiagramSizes& sizes);
float belowAxes(const DiagramSizes& sizes);
float aboveAxes(const DiagramAxes& axes, const DiagramSizes& sizes);

/// Whether a title has room upright beside a frame of this height, or at least its symbol and unit.
bool fitsUpright(const std::string& title, float height, const DiagramSizes& sizes);

void addDiagramGrid(DrawList& list, const DiagramAxes& axes, const DiagramSizes& sizes,
                    const Theme& theme);
/// Frame, ticks, labels and titles. `above`: pixels over the frame that something else takes.
void addDiagramFrame(DrawList& list, const DiagramAxes& axes, const DiagramSizes& sizes,
                     const Theme& theme, float above);
/// The outline of a box.
void addFrame(DrawLayer& layer, const Box& box, const Rgba& colour, float width);

}  // namespace asperity
