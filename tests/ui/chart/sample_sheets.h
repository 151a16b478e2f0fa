// Sheets of diagrams like the paper's figures, and some that nobody would wish to draw, for the
// tests of the pictures. Pure; any thread.
#pragma once

#include <vector>

#include "core/chart/diagram.h"

namespace asperity {

/// One series through these points, linear axes.
DiagramSheet sheetOf(const std::vector<DiagramPoint>& points);

/// Figs. 2 to 6: one curve with a band, regions and variants; six curves with theory; twenty on a
/// ramp with zones; two panels with linear axes; curves on a logarithmic and a linear axis.
std::vector<NamedSheet> figureSheets();

/// Too many names, too long texts, values that have no place, nothing at all.
std::vector<NamedSheet> awkwardSheets();

}  // namespace asperity
