// Diagrams as pictures, in the manner of a printed journal: axes with their units, curves with
// error bars or bands, theory lines, marks, regions, legends; several diagrams side by side. Pure
// functions of their arguments; the same picture on the screen, in PNG, SVG and PDF. Any thread.
#pragma once

#include <optional>

#include "core/chart/diagram.h"
#include "ui/draw/draw_list.h"
#include "ui/draw/theme.h"

namespace asperity {

/// The frame of a picture that stands above: diagrams below it have the same edges, and letters of
/// its unit. Pixels; 0: as the diagrams need by themselves.
struct FrameAbove {
  float left = 0, right = 0;
  float unit = 0;
};

struct DiagramOptions {
  int width = 1200, height = 800;  // pixels
  float scale = 1;                 // of fonts and line widths; 2 at twice the pixels
  Theme theme = lightTheme();
  float leastText =
      0;  // texts keep this size (1: usual) where a low picture would make them smaller
  std::optional<FrameAbove> above{};
};

/// A size fit for print: 2400 x 1600 pixels at scale 2 for one diagram, wider where there are
/// several.
DiagramOptions printOptions(const DiagramSheet& sheet, const Theme& theme = printTheme());

/// The lowest picture from options.height on, in steps of 10 pixels, in which every diagram of the
/// sheet has room for its frame and its name; 0 where none has, as it is not wide enough.
int heightForAll(const DiagramSheet& sheet, const DiagramOptions& options);

/// The height of the lowest frame of all, in heights of the numbers beside it; 0 where a frame has
/// no room and would be left out.
float lowestFrame(const DiagramSheet& sheet, const DiagramOptions& options);

/// The sheet without its last diagram, then without its note, where they would leave the others
/// too low to be read with ease.
DiagramSheet withoutCrowding(DiagramSheet sheet, const DiagramOptions& options);

/// Every text on the picture and none over another, from 320 x 200 pixels on; what finds no place
/// is shortened, then left out, units and powers of ten last. Never throws for what a sheet holds.
DrawList composeDiagrams(const DiagramSheet& sheet, const DiagramOptions& options);

}  // namespace asperity
