// The appearance of diagrams: the colours of series and fields, marks, strokes. The colours and the
// corners of marks are also those of the interactive charts. Pure; any thread. Pixels, y down.
#pragma once

#include <vector>

#include "core/chart/diagram.h"
#include "ui/chart/diagram_layout.h"
#include "ui/draw/shapes.h"
#include "ui/draw/theme.h"

namespace asperity {

inline constexpr int kDistinctColours = 9;

/// The colour of a marker, which differs from the present curve's, the first one.
inline constexpr int kMarkerColour = 1;

/// Opacities of objects that belong to an earlier state, of bands, and of shaded ranges.
inline constexpr float kFadedOpacity = 0.3F, kBandOpacity = 0.2F, kShadeOpacity = 0.1F;

/// Returns a colour of the palette of Okabe and Ito (2008), whose colours every colour vision can
/// distinguish, darkened or lightened where it would be too faint on the theme's background.
/// Repeats after kDistinctColours.
Rgba seriesColour(int index, const Theme& theme);

/// Returns a colour of "viridis", ordered by lightness for every colour vision, without the end
/// that is invisible on the theme's background. t in [0, 1].
Rgba rampColour(double t, const Theme& theme);

/// Returns a colour of the whole of "viridis", for areas that touch no background.
Rgba fieldColour(double t);

/// A line over a field: a light core within a dark edge, seen on all of the field's colours.
inline constexpr Rgba kLineOnField{1, 1, 1, 1}, kEdgeOnField{0, 0, 0, 0.75F};
inline constexpr float kLineOnFieldWidth = 1.6F, kEdgeOnFieldWidth = 4.2F;  // units

/// Returns the corners of a mark around a point, which appears as large as a circle `size` wide;
/// empty for a circle, a ring and no mark.
std::vector<DrawPoint> markCorners(SeriesMark mark, DrawPoint at, float size);

/// Returns how wide a mark of this size is; a ring is wider than the mark that it encloses.
float markWidth(SeriesMark mark, float size);

/// Draws a filled mark with smooth edges.
void addMark(DrawLayer& layer, SeriesMark mark, DrawPoint at, float size, const Rgba& colour);

/// Adds a rim that separates a mark from objects under it; its layer is below the mark's.
void addMarkRim(DrawLayer& layer, SeriesMark mark, DrawPoint at, float size, float rim,
                const Rgba& colour);

/// Returns whether any point of a series has an error bar.
bool hasErrorBars(const DiagramSeries& series);

/// Returns whether the axes of its diagram can show any point of a series.
bool hasPoints(const DiagramSeries& series, const Diagram& diagram);

/// The appearance of a series in its diagram and in the legend. Pixels.
struct SeriesStyle {
  Rgba colour;
  float width = 2;
  SeriesStroke stroke = SeriesStroke::Solid;
  SeriesMark mark = SeriesMark::None;
  float markSize = 7;
  bool isBand = false, hasBars = false;
};

/// Returns one style for each series; marks shrink where points are dense in a frame `pixels` wide.
std::vector<SeriesStyle> seriesStyles(const Diagram& diagram, const DiagramSizes& sizes,
                                      const Theme& theme, float pixels);

/// Adds a line in a series' stroke.
void addStroke(DrawLayer& layer, const std::vector<DrawPoint>& points, const SeriesStyle& style);

}  // namespace asperity
