// Writes the line of a scene as text: its points as CSV that the profile reader accepts; its
// statistics and spectrum as tables and as JSON, with the summary of a measured surface. And the
// scene of a file that is such a line, or a measured surface. Pure functions, except for reading
// that file; equal scenes give equal bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/input_error.h"
#include "core/scene/data_table.h"
#include "core/scene/scene.h"
#include "core/surface/line.h"
#include "core/surface/line_source.h"
#include "core/surface/measured_summary.h"

namespace asperity {

/// Returns the default scene with the file of a surface, and the assignments. A line that this
/// program wrote (lineCsv) is not processed again: it is already levelled, filtered and turned
/// over. Throws InputError.
Scene surfaceFileScene(const std::filesystem::path& file,
                       const std::vector<std::string>& assignments);

/// Runs `work` on such a scene, whose file is all that the user names: an error of the file names
/// it once, and not the key that a scene has for it.
template <class Work>
auto withSurfaceFile(const std::string& file, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    const std::vector<Message>& parts = error.message().values;
    if (error.key() == "surface.file" && parts.size() == 2) throw InputError(file, "", parts[1]);
    throw error.isOfOption() ? error : error.withFile(file);
  }
}

/// Returns the points per element of a written line. A line from a file is written with its
/// elements alone, and so is a line that this program wrote: read as a profile it is the same line.
/// isOfFile: the scene is surfaceFileScene().
std::int64_t writtenPointsPerElement(const Scene& scene, bool isOfFile);

/// Returns a table "position,height" in metres.
std::string lineCsv(const Line& line);

/// Returns "wave_number", "power_spectral_density" of the waves of a line, and "reliable" for that
/// of a measured surface; no rows for a line without modes.
DataTable spectrumTable(const LineSource& source, const MeasuredSummary* measured = nullptr);

/// Returns "quantity", "unit", "value", "raw": the statistics of the line, then the parameters of
/// ISO 21920-2 of a measured surface before and after processing. measured: null for other lines.
DataTable statisticsTable(const Line& line, const MeasuredSummary* measured);

/// Adds how the scene's file was read (readingFacts) to an answer in JSON, as `reading.facts`.
/// Nothing is added where there are no facts.
void addReadingFacts(nlohmann::ordered_json& answer, const std::vector<Message>& facts);

/// Returns the statistics (Rq of ISO is rms_height, Rdq is rms_slope) and the power spectral
/// density C(q) (m^3) over q (1/m) for lines that have modes. measured: with its spectra; null for
/// other lines.
std::string surfaceJson(const Scene& scene, const LineSource& source, const Line& line,
                        const MeasuredSummary* measured);

}  // namespace asperity
