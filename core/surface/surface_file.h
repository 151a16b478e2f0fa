// Writes the line of a scene as text: its points as CSV that the profile reader accepts; its
// statistics and spectrum as tables and as JSON, with the summary of a measured surface. Pure
// functions; equal scenes give equal bytes.
#pragma once

#include <string>

#include "core/scene/data_table.h"
#include "core/scene/scene.h"
#include "core/surface/line.h"
#include "core/surface/line_source.h"

namespace asperity {

/// Returns a table "position,height" in metres.
std::string lineCsv(const Line& line);

/// Returns "wave_number", "power_spectral_density" of the waves of a line; no rows for a line
/// without modes.
DataTable spectrumTable(const LineSource& source);

/// Returns "quantity", "unit", "value", "raw": the statistics of the line, then the parameters of
/// ISO 21920-2 of a measured surface before and after processing.
DataTable statisticsTable(const Scene& scene, const LineSource& source, const Line& line);

/// Returns the statistics (Rq of ISO is rms_height, Rdq is rms_slope) and the power spectral
/// density C(q) (m^3) over q (1/m) for lines that have modes.
std::string surfaceJson(const Scene& scene, const LineSource& source, const Line& line);

}  // namespace asperity
