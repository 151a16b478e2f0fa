// The axes of a diagram: their ranges, their ticks and the way from values to pixels. Private to
// ui/chart. Pure; any thread.
#pragma once

#include "core/chart/diagram.h"
#include "ui/chart/diagram_layout.h"
#include "ui/draw/plot_axes.h"

namespace asperity {

/// In an axis' own measure: decimal logarithms on a logarithmic one.
struct AxisRange {
  double from = 0, to = 1;
};

/// The value itself or its decimal logarithm; NaN where it has no place on the axis.
double axisPlace(AxisScale scale, double value);

/// As the axis says, otherwise as the data need; theory counts where there are no data.
AxisRange rangeAlong(const Diagram& diagram);
/// Of the points inside the range along x; theory lines widen it a little.
AxisRange rangeUp(const Diagram& diagram, const AxisRange& along);

/// With as many ticks as have room in `pixels`.
PictureAxis diagramAxisAlong(const DiagramAxis& axis, const AxisRange& range, float pixels,
                             const DiagramSizes& sizes);
PictureAxis diagramAxisUp(const DiagramAxis& axis, const AxisRange& range, float pixels,
                          const DiagramSizes& sizes);

struct DiagramAxes {
  PlotAxes plot;
  AxisScale along = AxisScale::Linear, up = AxisScale::Linear;
  bool saysAlong = true;    // false: labels and title stand under another frame below
  bool titleAbove = false;  // the title of the axis up lies over the frame, not upright beside it

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

}  // namespace asperity
