// The legend of a diagram: the meaning of colours, strokes and marks. Private to ui/chart. Pure;
// any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/chart/diagram_style.h"

namespace asperity {

struct LegendEntry {
  std::string name;
  SeriesStyle style;
  bool hasSample = true;
  DrawPoint origin{};  // upper left corner of its row, relative to the first row
};

/// A legend that is measured and can be placed; empty where there are no entries.
struct Legend {
  std::vector<LegendEntry> entries;
  std::optional<DiagramRamp> ramp;
  float size = 12;  // of the font
  int columns = 1;
  float width = 0, height = 0;
  bool isWhole = true;  // no entry is missing or shortened
  bool empty() const { return entries.empty() && !ramp; }
};

/// Makes a legend of at most this size; long names are shortened, entries that do not fit are
/// counted in the last one ("and 7 more").
Legend legendFor(const Diagram& diagram, const std::vector<SeriesStyle>& styles, float size,
                 float width, float height);

/// Makes a legend in rows that are filled one after the other. No name is shortened; it is not
/// whole where a name is too long for this width.
Legend legendOver(const Diagram& diagram, const std::vector<SeriesStyle>& styles, float size,
                  float width);

/// Adds the legend on a plate in the background's colour.
void addLegend(DrawList& list, const Legend& legend, const Box& box, bool framed,
               const DiagramSizes& sizes, const Theme& theme);

}  // namespace asperity
