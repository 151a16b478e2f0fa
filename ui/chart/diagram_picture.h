// Diagrams as pictures in the style of a printed journal: axes with their units, curves with error
// bars or bands, theory lines, marks, regions, legends; several diagrams side by side. Pure
// functions of their arguments; the same picture on the screen, in PNG, SVG and PDF. Any thread.
#pragma once

#include <optional>
#include <vector>

#include "core/chart/diagram.h"
#include "core/chart/figure_style.h"
#include "ui/chart/chart_geometry.h"
#include "ui/draw/draw_list.h"
#include "ui/draw/theme.h"

namespace asperity {

/// The frame of a picture above the diagrams: they have the same left and right edges, and texts of
/// its unit. Pixels; 0: automatic.
struct FrameAbove {
  float left = 0, right = 0;
  float unit = 0;
};

/// Sizes in pixels and the positions of legend and ticks, as the user sets them; 0: automatic.
struct DiagramFormat {
  float fontSize = 0;     // of the tick labels; other texts are scaled with it
  float lineWidth = 0;    // of curves
  float minFontSize = 0;  // of any text
  LegendMode legend = LegendMode::Automatic;
  TickSide ticks = TickSide::Automatic;
};

struct DiagramOptions {
  int width = 1200, height = 800;  // pixels
  float scale = 1;                 // of fonts and line widths; 2 for twice the pixels
  Theme theme = lightTheme();
  float minTextSize = 0;  // of texts in a low picture, relative to the usual size; 1: usual
  std::optional<FrameAbove> above{};
  DiagramFormat format{};
};

/// Returns options for print: 2400 x 1600 pixels at scale 2 for one diagram, wider for several.
DiagramOptions printOptions(const DiagramSheet& sheet, const Theme& theme = printTheme());

/// Returns the height of the lowest picture, from options.height in steps of 10 pixels, in which
/// every diagram of the sheet fits with its frame and its name; 0 where the width is too small.
int heightForAll(const DiagramSheet& sheet, const DiagramOptions& options);

/// Returns the height of the lowest picture of this width, from options.height on, in which letters
/// of a given size (options.format.fontSize) leave nothing out: every frame is high enough, every
/// title and legend complete. options.height where there is no such height.
int heightInPrint(const DiagramSheet& sheet, const DiagramOptions& options);

/// Returns whether every frame is high enough, and every title and legend complete; no legend lies
/// over curves.
bool isWhole(const DiagramSheet& sheet, const DiagramOptions& options);

/// Returns the height of the lowest frame, in heights of the numbers beside it; 0 where a frame
/// does not fit and would be left out.
float lowestFrame(const DiagramSheet& sheet, const DiagramOptions& options);

/// Returns the sheet without its last diagram, then without its note, where they would make the
/// others too low to read easily.
DiagramSheet withoutCrowding(DiagramSheet sheet, const DiagramOptions& options);

/// Returns the frames of the diagrams in the picture that composeDiagrams() draws.
std::vector<ChartGeometry> diagramFrames(const DiagramSheet& sheet, const DiagramOptions& options);

/// Draws the sheet. No text covers another, from 320 x 200 pixels on; texts that do not fit are
/// shortened, then left out, units and powers of ten last. Never throws because of a sheet's
/// content.
DrawList composeDiagrams(const DiagramSheet& sheet, const DiagramOptions& options);

}  // namespace asperity
