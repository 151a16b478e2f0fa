// Where the diagrams of an interactive chart are: below each other over their common x-axis; those
// that do not fit are left out, the last ones first. Pure; GUI thread, because it measures fonts.
#pragma once

#include <QSizeF>
#include <vector>

#include "core/chart/diagram.h"
#include "ui/chart/chart_geometry.h"
#include "ui/chart/chart_style.h"

namespace asperity {

struct ChartLayout {
  std::vector<ChartGeometry> frames;  // of the diagrams that fit
  // Titles of the y-axes are upright on the left, except where there is no space for them:
  double titleBeside = 0;       // width of those on the right, of strips; 0: there are none
  bool hasTitlesAbove = false;  // the diagrams below the first have them above their frames
};

/// Lays out the diagrams in this many pixels. The margins depend only on the longest possible
/// texts, so that the frames do not move during a zoom. `hasChoosers`: widgets outside of the chart
/// take the place of the titles of the x-axis and of the first y-axis.
ChartLayout layOutChart(const DiagramSheet& sheet, const VisibleRange& shown, const QSizeF& size,
                        const ChartStyle& style, bool hasChoosers);

}  // namespace asperity
