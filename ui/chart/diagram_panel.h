// One diagram of a picture: first its parts are placed so that none hides another, then they are
// drawn. Private to ui/chart. Pure; any thread. Pixels, y down.
#pragma once

#include <string>
#include <vector>

#include "core/chart/diagram.h"
#include "ui/chart/chart_geometry.h"
#include "ui/chart/diagram_annotations.h"
#include "ui/chart/diagram_axes.h"
#include "ui/chart/diagram_layout.h"
#include "ui/chart/diagram_legend.h"
#include "ui/chart/diagram_style.h"
#include "ui/chart/occupancy_grid.h"

namespace asperity {

class DiagramPanel {
 public:
  /// `above`: pixels for the title and the names of regions, the same for all of a sheet.
  /// `hasXLabels`: labels and title of the x-axis are drawn. `titleAbove`: the title of the y-axis
  /// is over the frame. `isAligned`: alignTo() will be called. `isInRow`: other panels stand beside
  /// this one. The diagram must outlive the panel.
  DiagramPanel(const Diagram& diagram, const Box& cell, float above, bool hasXLabels,
               bool titleAbove, bool isAligned, bool isInRow, const DiagramSizes& sizes,
               const Theme& theme);

  /// Sets the left and right edges of the frame, aligned with others; the legend is inside or above
  /// it.
  void alignTo(float left, float right);

  /// Lowers the top of the frame to one beside it. The legend may then go into the space above.
  void lowerTo(float top);

  const Box& frame() const { return axes_.box; }
  ChartGeometry geometry() const;

  /// Returns whether the title of the y-axis fits.
  bool hasTitle() const;
  /// Returns whether that title is shown in words, not by its symbol alone.
  bool hasTitleInWords() const;
  /// Returns whether the frame is large enough to be drawn.
  bool isReadable() const;
  /// Returns whether the frame is readable, with an upright title beside it and at least two ticks.
  bool isWellReadable() const { return isReadable() && axes_.box.height >= 7 * sizes_.tick; }
  /// Returns whether nothing is missing in print: the frame is high enough, and title and legend
  /// are complete and hide next to nothing. Letters on paper cannot get smaller.
  bool isWhole() const;
  /// Returns whether the legend names everything and hides next to nothing.
  bool hasWholeLegend() const;

  /// Adds the diagram; nothing where the frame would be too small to read.
  void addTo(DrawList& list) const;

 private:
  std::vector<DrawPoint> markerLine() const;
  void addMarkerLine(DrawList& list) const;
  std::vector<std::string> sentenceLines() const;
  Box sentenceBox() const;
  void addSentence(DrawList& list) const;
  void arrange();
  void arrangeLegend();
  float smallestLegend() const;
  bool fitBelow();
  Legend legendBelow(float size) const;
  void placeBelow(Legend below);
  void place(float right, float above);
  std::vector<PlacedLabel> labelsOn(OccupancyGrid& map) const;
  void placeLegend(const OccupancyGrid& map);
  float overhang() const;

  const Diagram& diagram_;
  Box cell_;
  DiagramSizes sizes_;
  Theme theme_;
  AxisRange xRange_;
  DiagramAxes axes_;
  TickedAxis colours_;  // of a field
  std::vector<SeriesStyle> styles_;
  std::vector<PlacedLabel> labels_;
  Legend legend_;
  bool isInRow_;                // with others, whose frames have the same width
  bool isAligned_;              // with the frames of other diagrams or of a picture above
  float top_ = 0, bottom_ = 1;  // of the frame if no legend is above it
  float headroom_ = 0;          // minimum space above the frame
  float left_ = 0;              // minimum left edge of the frame
  float right_ = 0;             // right edge of the frame; 0: automatic
  bool showsLegend_ = true;
  float legendSize_ = 12;  // of its letters
  float below_ = 0;        // pixels of a legend below the axis
  Box legendBox_;          // width 0: not shown
  float hidden_ = 0;       // part of the legend's box that hides something
};

}  // namespace asperity
