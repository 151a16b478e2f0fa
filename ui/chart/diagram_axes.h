// The axes of a diagram: their ranges, ticks and titles, and the map from values to pixels. Private
// to ui/chart. Pure; any thread. Pixels, y down.
#pragma once

#include <string>
#include <vector>

#include "core/chart/diagram.h"
#include "ui/chart/chart_geometry.h"
#include "ui/chart/diagram_layout.h"
#include "ui/draw/shapes.h"
#include "ui/draw/theme.h"
#include "ui/draw/ticks.h"

namespace asperity {

/// Returns the x-range: as the axis prescribes, otherwise as the data need; theory counts where
/// there are no data.
AxisRange xRange(const Diagram& diagram);
/// Returns the y-range of the points inside the x-range; theory lines widen it a little.
AxisRange yRange(const Diagram& diagram, const AxisRange& inX);

/// Returns whether the y-axis has no values, as that of a motion before its first step: its numbers
/// would mean nothing.
bool hasNoValues(const Diagram& diagram);

/// An axis with as many ticks as fit its length.
struct TickedAxis {
  AxisScale scale = AxisScale::Linear;
  AxisRange range{0, 1};
  std::vector<Tick> ticks;
  std::vector<double> minor;  // positions of the minor ticks
  std::string title;          // "velocity v (mm/s)"; the ticks have the same prefix
};
TickedAxis tickedXAxis(const DiagramAxis& axis, const AxisRange& range, float pixels,
                       const DiagramSizes& sizes);
TickedAxis tickedYAxis(const DiagramAxis& axis, const AxisRange& range, float pixels,
                       const DiagramSizes& sizes);

/// Returns the symbol at the end of a name: "G′" of "storage modulus G′"; empty where there is
/// none.
std::string trailingSymbol(const std::string& name);

/// A title in the largest of several sizes that fits.
struct FittedTitle {
  std::string text;
  float size = 12;
};
/// Fits a title. First words are left out, then everything but the symbol and the unit; the unit
/// with its power of ten stays, because the numbers on the axis would be wrong without it.
FittedTitle fittedTitle(const std::string& title, float size, float pixels);

/// The frame of a diagram and its axes.
struct DiagramAxes {
  Box box;
  TickedAxis xAxis, yAxis;
  bool hasXLabels = true;   // false: another frame below shows labels and title
  bool titleAbove = false;  // the title of the y-axis is above the frame, not upright beside it

  /// These functions map a value, or its decimal logarithm, to pixels.
  float px(double x) const;
  float py(double y) const;
  /// Returns a position in pixels, at most 1e6 from the origin; NaN where an axis cannot show a
  /// value.
  DrawPoint mapToPosition(double x, double y) const;
};

/// These functions return the pixels left of the frame for title and labels, below it where it
/// shows the x-axis' labels, and above it where it shows the title of the y-axis there.
float leftOfAxes(const DiagramAxes& axes, const DiagramSizes& sizes);
float belowAxes(const DiagramSizes& sizes);
float aboveAxes(const DiagramAxes& axes, const DiagramSizes& sizes);

/// Returns whether a title, or at least its symbol and unit, fits upright beside a frame of this
/// height.
bool fitsUpright(const std::string& title, float height, const DiagramSizes& sizes);

/// Returns whether the whole title fits upright beside a frame of this height.
bool fitsUprightInWords(const std::string& title, float height, const DiagramSizes& sizes);

/// Returns the width of the lines of axes, whole pixels.
float axisLineWidth(const DiagramSizes& sizes);
/// Returns the middle of a line of a whole width that covers whole pixels; between them it would be
/// pale and wide.
float onWholePixels(float pixel, float width);
/// Adds the frame around a box.
void addAxisFrame(DrawLayer& layer, const Box& box, float width, const Theme& theme);

void addDiagramGrid(DrawList& list, const DiagramAxes& axes, const DiagramSizes& sizes,
                    const Theme& theme);
/// Adds frame, ticks, labels and titles. `above`: pixels over the frame that another part uses.
void addDiagramFrame(DrawList& list, const DiagramAxes& axes, const DiagramSizes& sizes,
                     const Theme& theme, float above);

}  // namespace asperity
