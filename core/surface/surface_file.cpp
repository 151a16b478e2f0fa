#include "core/surface/surface_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/embedded_provenance.h"
#include "core/base/json_text.h"
#include "core/base/regular_file.h"
#include "core/base/statistics.h"
#include "core/scene/columns.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "core/surface/measured_summary.h"
#include "core/surface/spectrum.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// Returns C(q_k) = a_k^2 / (4 dq) of the waves of a line, so that h^2 = 2 sum C dq.
SpectralDensity lineSpectrum(const FourierLine& modes) {
  const double lowest = 2 * std::numbers::pi / modes.length;
  SpectralDensity spectrum;
  for (std::size_t j = 0; j < modes.coefficients.size(); ++j) {
    spectrum.waveNumber.push_back(lowest * static_cast<double>(j + 1));
    spectrum.density.push_back(std::norm(modes.coefficients[j]) / lowest);
  }
  return spectrum;
}

std::string_view unitSourceWord(UnitSource source) {
  return source == UnitSource::File ? "file" : source == UnitSource::Choice ? "choice" : "assumed";
}

Json unitJson(const UnitFact& unit) {
  return {{"unit", unit.unit}, {"metres", unit.metres}, {"source", unitSourceWord(unit.source)}};
}

Json spectrumJson(const SpectralDensity& spectrum) {
  return {{"wave_number", spectrum.waveNumber}, {"power_spectral_density", spectrum.density}};
}

/// Adds "reading", "values", "spectrum_of_surface" and "notes" of a measured surface.
void addMeasured(Json& root, const MeasuredSummary& summary) {
  const ReadingFacts& facts = summary.facts;
  Json& reading = root["reading"];
  reading = {{"format", facts.format},
             {"columns", summary.columns},
             {"rows", summary.rows},
             {"spacing", summary.spacing},
             {"row_spacing", summary.rowSpacing},
             {"position_column", facts.positionColumn},
             {"height_column", facts.heightColumn},
             {"position_unit", unitJson(facts.positionUnit)},
             {"height_unit", unitJson(facts.heightUnit)},
             {"points", facts.points},
             {"gaps", facts.gaps},
             {"spacing_variation", facts.spacingVariation},
             {"resampled", facts.resampled},
             {"row", summary.rowInFile},
             {"rows_used", summary.rowsUsed},
             {"rows_left_out", summary.missing.rowsLeftOut},
             {"gaps_interpolated", summary.profile.gaps},
             {"outliers_interpolated", summary.profile.outliers}};
  addReadingFacts(root, factsOf(summary));
  Json raw, used;
  for (const NamedValue& value : namedValues(summary)) {
    raw["P" + value.name.substr(1)] = numberOrNull(value.raw);
    used[value.name] = numberOrNull(value.used);
  }
  root["values"] = {{"raw", std::move(raw)},
                    {"used", std::move(used)},
                    {"length", summary.used.length},
                    {"height_ratio", summary.ratios.height},
                    {"slope_ratio", summary.ratios.slope}};
  root["spectrum_of_surface"] = {{"reliable_from", summary.band.from},
                                 {"reliable_to", summary.band.to},
                                 {"ends_in_noise", summary.band.endsInNoise},
                                 {"raw", spectrumJson(summary.rawSpectrum)},
                                 {"used", spectrumJson(summary.usedSpectrum)}};
  root["notes"] = Json::array();
  for (const Note note : summary.notes.list()) root["notes"].push_back(noteWord(note));
}

/// Returns whether the table is a line that this program wrote.
bool isWrittenLine(const std::filesystem::path& file) {
  constexpr std::size_t kBeginning = std::size_t{1} << 20;  // bytes; the record is its first line
  const std::string beginning = RegularFile(file).read(0, kBeginning);
  if (!beginning.starts_with('#') || beginning.find("\nposition,height\n") == std::string::npos)
    return false;
  const auto record = jsonOrDiscarded(embeddedProvenance(beginning));
  return record.is_object() && record.contains("verb") && record["verb"] == "surface";
}

}  // namespace

Scene surfaceFileScene(const std::filesystem::path& file,
                       const std::vector<std::string>& assignments) {
  const char* const kind = isWrittenLine(file) ? "profile" : "measured";
  const Json json = {{"surface", {{"kind", kind}, {"file", file.filename().string()}}}};
  return readScene(jsonLine(json), file.string(), file.parent_path(), assignments);
}

std::int64_t writtenPointsPerElement(const Scene& scene, bool isOfFile) {
  const SurfaceKind kind = scene.surface.kind;
  const bool isExact =
      isOfFile || kind == SurfaceKind::Measured || kind == SurfaceKind::Spectrum ||
      (kind == SurfaceKind::Profile && isWrittenLine(scene.folder / scene.surface.file));
  return isExact ? 1 : pointsPerElement(scene);
}

std::string lineCsv(const Line& line) {
  std::string text = tableCsv({columnNames({"position", "height"}), {}});
  for (std::size_t i = 0; i < line.nodes(); ++i)
    fmt::format_to(std::back_inserter(text), "{},{}\n", static_cast<double>(i) * line.spacing,
                   line.height[i]);
  return text;
}

DataTable spectrumTable(const LineSource& source, const MeasuredSummary* measured) {
  DataTable table{columnNames({"wave_number", "power_spectral_density"}), {}};
  if (measured) table.columns.push_back(ColumnName("reliable").text());
  const SpectralDensity spectrum = lineSpectrum(source.spectrum(0));
  for (std::size_t j = 0; j < spectrum.density.size(); ++j) {
    const double waveNumber = spectrum.waveNumber[j];
    table.rows.push_back({waveNumber, spectrum.density[j]});
    if (!measured) continue;
    const ReliableBand& band = measured->band;
    const bool isReliable = waveNumber >= band.from && waveNumber <= band.to;
    table.rows.back().emplace_back(std::int64_t{isReliable});
  }
  return table;
}

DataTable statisticsTable(const Line& line, const MeasuredSummary* measured) {
  const auto [lowest, highest] = std::minmax_element(line.height.begin(), line.height.end());
  DataTable table{columnNames({"quantity", "unit", "value", "raw"}), {}};
  const auto add = [&](const char* name, const char* unit, TableCell value) {
    table.rows.push_back({std::string(name), std::string(unit), std::move(value), kNaN});
  };
  add("length", "m", line.length);
  add("points", "", static_cast<std::int64_t>(line.nodes()));
  add("spacing", "m", line.spacing);
  add("rms_height", "m", line.rmsHeight);
  add("rms_slope", "", line.rmsSlope);
  add("lowest", "m", *lowest);
  add("highest", "m", *highest);
  if (measured)
    for (const NamedValue& value : namedValues(*measured))
      table.rows.push_back({value.name, value.unit, value.used, value.raw});
  return table;
}

void addReadingFacts(nlohmann::ordered_json& answer, const std::vector<Message>& facts) {
  for (const Message& fact : facts) answer["reading"]["facts"].push_back(fact.english());
}

std::string surfaceJson(const Scene& scene, const LineSource& source, const Line& line,
                        const MeasuredSummary* measured) {
  const auto [lowest, highest] = std::minmax_element(line.height.begin(), line.height.end());
  Json root = provenance("surface", scene);
  root["statistics"] = {{"length", line.length},      {"points", line.nodes()},
                        {"spacing", line.spacing},    {"rms_height", line.rmsHeight},
                        {"rms_slope", line.rmsSlope}, {"lowest", *lowest},
                        {"highest", *highest}};
  const SpectralDensity spectrum = lineSpectrum(source.spectrum(0));
  root["spectrum"] = spectrum.empty() ? Json(nullptr) : spectrumJson(spectrum);
  if (measured) addMeasured(root, *measured);
  addReadingFacts(root, source.spectrumFacts());
  return jsonFile(root);
}

}  // namespace asperity
