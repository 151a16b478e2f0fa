// The layout of a sheet of diagrams. Private to ui/chart. Plain values; any thread.
#pragma once

#include <vector>

#include "ui/chart/diagram_picture.h"
#include "ui/draw/fonts.h"
#include "ui/draw/shapes.h"

namespace asperity {

/// Sizes in pixels; whole numbers for fonts, because the painter knows no others.
struct DiagramSizes {
  float unit = 1;  // of line widths and distances
  float title = 19, subtitle = 13, panel = 14, axis = 14, tick = 12, legend = 12, note = 11;
  float minFontSize = kSmallestFont;  // of any text
  float curve = 0;                    // width of curves; 0: by the unit
  LegendMode legendMode = LegendMode::Automatic;
  TickSide ticks = TickSide::Inside;
  bool isPrinted = false;  // letters have a given size
};

/// Rows and columns of the diagrams on a sheet.
struct SheetGrid {
  int columns = 1, rows = 1;
};
SheetGrid gridFor(const DiagramSheet& sheet);

/// Returns whether only the lowest diagram shows the labels of the x-axis.
bool hasCommonAxis(const DiagramSheet& sheet);

/// Returns whether the diagrams are strips: at least three above a common x-axis, which are too low
/// for upright titles in words.
bool hasStrips(const DiagramSheet& sheet);

/// Returns the sizes. Fonts grow with the picture, but more slowly, and always leave space for the
/// curves.
DiagramSizes sizesFor(const DiagramSheet& sheet, const DiagramOptions& options);

/// Returns the cells of the sheet's diagrams between `top` and `bottom`, in order, with this many
/// units between them.
std::vector<Box> cellsFor(const DiagramSheet& sheet, const DiagramOptions& options, float top,
                          float bottom, const DiagramSizes& sizes, float between);

/// Adds title and subtitle; returns the pixels that they take from the top.
float addHeading(DrawList& list, const DiagramSheet& sheet, const DiagramSizes& sizes,
                 const Theme& theme);

/// Adds the note at the bottom; returns the row where it begins.
float addNote(DrawList& list, const DiagramSheet& sheet, const DiagramSizes& sizes,
              const Theme& theme);

/// Returns the margin at the left and right edges of the picture, in pixels.
float sheetMargin(const DiagramSizes& sizes);

}  // namespace asperity
