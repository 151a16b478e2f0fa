// A pair of axes for diagrams drawn by this program itself: linear or logarithmic, with as many
// ticks as have room. Pure; any thread. Pixels, y down.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/draw/theme.h"
#include "ui/draw/shapes.h"
#include "ui/draw/ticks.h"

namespace asperity {

struct PlotTick {
  double value = 0;  // as the axis' from and to
  std::string label;
};

struct PictureAxis {
  double from = 0, to = 1;  // SI; the decimal logarithms of it on a logarithmic axis
  std::vector<PlotTick> ticks;
  std::string title, shortTitle;  // the short one where there is no room for the other
  std::vector<double> minor;      // between the ticks, as from and to
};

/// Ticks whose labels, written side by side in fonts of `size`, fit `pixels`.
AxisTicks roomyTicks(double from, double to, float pixels, float size, std::string_view unit);

/// Ticks upwards, `each` pixels for one of them; a low axis has closer ones as far as labels in
/// fonts of `size` have room, because a single tick says nothing of the scale.
AxisTicks ticksUp(double from, double to, float pixels, float each, float size,
                  std::string_view unit);

/// A horizontal and a vertical linear axis; titles become "position (mm)".
PictureAxis linearAxisAlong(double from, double to, float pixels, float size,
                            const std::string& name, std::string_view unit);
PictureAxis linearAxisUp(double from, double to, float pixels, float size, const std::string& name,
                         std::string_view unit);

/// `from` and `to` are decimal logarithms. At most `most` ticks.
PictureAxis logarithmicAxis(double from, double to, int most, std::string title,
                            std::string shortTitle);

/// "position (mm)"; the name alone without a unit.
std::string titleWithUnit(const std::string& name, const std::string& unit);

/// The widest label of an axis.
float widestLabel(const PictureAxis& axis, float size);

struct PlotAxes {
  Box box;
  PictureAxis along, up;

  float px(double x) const;
  float py(double y) const;
};

/// The parts of addPlotAxes. Ticks point inwards from all four sides, minor ones half as far.
void addGridLines(DrawLayer& layer, const PlotAxes& axes, const Theme& theme, float unit);
void addFrame(DrawLayer& layer, const Box& box, const Rgba& colour, float width);
void addTickMarks(DrawLayer& layer, const PlotAxes& axes, const Rgba& colour, float width,
                  float length);
void addTickLabels(DrawList& list, const PlotAxes& axes, const Rgba& colour, float size);

/// Grid, frame, labels and titles: texts of `size`, lines `unit` pixels wide. The labels take
/// kPlotBelow times `size` below the box, the title upwards stands at x = 1.5 times `size`.
void addPlotAxes(DrawList& list, const PlotAxes& axes, const Theme& theme, float size, float unit);
inline constexpr float kPlotBelow = 3.5F;

}  // namespace asperity
