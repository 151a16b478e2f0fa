// The picture of a measured surface: the profile as it was and as it is used, both spectra with the
// band in which they speak of roughness, and how the heights are distributed. Summits are up. Pure;
// any thread.
#pragma once

#include "core/chart/diagram.h"
#include "core/surface/measured_summary.h"

namespace asperity {

/// title: of the sheet; empty: "Measured surface".
DiagramSheet measuredSheet(const MeasuredSummary& summary, const std::string& title);
/// Returns the text below the sheet, which explains its signs.
Message measuredSheetNote();

}  // namespace asperity
