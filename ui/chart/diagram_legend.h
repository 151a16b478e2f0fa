// What the colours, strokes and marks of a diagram mean. Private to ui/chart. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/chart/diagram_series.h"
#include "ui/draw/occupancy_grid.h"

namespace asperity {

struct LegendEntry {
  std::string name;
  SeriesStyle style;
  bool hasSample = true;
  Place place{};  // of its row's upper left corner, from that of the first row
};

/// Measured and ready to be put somewhere; empty where there is nothing to say.
struct Legend {
  std::vector<LegendEntry> entries;
  std::optional<DiagramRamp> ramp;
  float size = 12;  // of the font
  int columns = 1;
  float width = 0, height = 0;
  bool isWhole = true;  // no entry is missing or shortened
  bool empty() const { return entries.empty() && !ramp; }
};

/// At most this large; names that are too long are shortened, entries without room are counted in
/// the last one ("and 7 more").
Legend legendFor(const Diagram& diagram, const std::vector<SeriesStyle>& styles, float size,
                 float width, float height);

/// In rows that are filled one after the other, nothing shortened; not whole where one name is too
/// long for this width.
Legend legendOver(const Diagram& diagram, const std::vector<SeriesStyle>& styles, float size,
                  float width);

/// On a plate of the background's colour.
void addLegend(DrawList& list, const Legend& legend, const Box& box, bool framed,
               const DiagramSizes& sizes, const Theme& theme);

}  // namespace asperity
