// Diagrams as pictures in the style of a printed journal: axes with their units, curves with error
// bars or bands, theory lines, marks, regions, legends; several diagrams side by side. Pure
// functions of their arguments; the same picture on the screen, in PNG, SVG and PDF. Any thread.
#pragma once

#include <optional>
#include <vector>

#include "core/chart/diagram.h"
#include "core/chart/figure_style.h"
#include "ui/draw/draw_list.h"
#include "ui/draw/theme.h"

namespace asperity {

/// The frame of a picture above the diagrams: they have the same left and right edges, and texts of
/// its unit. Pixels; 0: automatic.
struct FrameAbove {
  float left = 0, right = 0;
  float unit = 0;
};

/// Sizes and places that a user asks for, in pixels; 0: automatic.
struct FigureLook {
  float letters = 0;  // of the numbers at the axes; other texts follow
  float curve = 0;    // width of curves
  float least = 0;    // no text is smaller
  LegendMode legend = LegendMode::Automatic;
  TickSide ticks = TickSide::Inside;
};

struct DiagramOptions {
  int width = 1200, height = 800;  // pixels
  float scale = 1;                 // of fonts and line widths; 2 for twice the pixels
  Theme theme = lightTheme();
  // minimum size of texts in a low picture, relative to the usual size; 1: usual
  float leastText = 0;
  std::optional<FrameAbove> above{};
  FigureLook look{};
};

/// Returns a size for print: 2400 x 1600 pixels at scale 2 for one diagram, wider for several.
DiagramOptions printOptions(const DiagramSheet& sheet, const Theme& theme = printTheme());

/// Returns the height of the lowest picture, from options.height in steps of 10 pixels, in which
/// every diagram of the sheet fits with its frame and its name; 0 where the width is too small.
int heightForAll(const DiagramSheet& sheet, const DiagramOptions& options);

/// Returns the height of the lowest picture of this width, from options.height on, in which letters
/// of a given size (options.look.letters) leave nothing out: every frame has a fair height, every
/// title and legend is whole. options.height where there is none.
int heightInPrint(const DiagramSheet& sheet, const DiagramOptions& options);

/// Returns the height of the lowest frame, in heights of the numbers beside it; 0 where a frame
/// does not fit and would be left out.
float lowestFrame(const DiagramSheet& sheet, const DiagramOptions& options);

/// Returns the sheet without its last diagram, then without its note, where they would make the
/// others too low to read easily.
DiagramSheet withoutCrowding(DiagramSheet sheet, const DiagramOptions& options);

/// Where a diagram of a sheet is in its picture, and what the edges of its frame mean.
struct DiagramFrame {
  float left = 0, top = 0, width = 0, height = 0;  // pixels
  AxisScale xScale = AxisScale::Linear, yScale = AxisScale::Linear;
  double xFrom = 0, xTo = 0, yFrom = 0, yTo = 0;  // values at the edges

  /// The values at a place, and back. Pixels, y down.
  double xAt(float right) const;
  double yAt(float down) const;
  float rightOf(double x) const;
  float downOf(double y) const;
};

/// Returns the frames of the diagrams in the picture that composeDiagrams() draws.
std::vector<DiagramFrame> diagramFrames(const DiagramSheet& sheet, const DiagramOptions& options);

/// Draws the sheet. No text covers another, from 320 x 200 pixels on; texts that do not fit are
/// shortened, then left out, units and powers of ten last. Never throws because of a sheet's
/// content.
DrawList composeDiagrams(const DiagramSheet& sheet, const DiagramOptions& options);

}  // namespace asperity
