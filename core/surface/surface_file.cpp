#include "core/surface/surface_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/scene/columns.h"
#include "core/scene/provenance.h"
#include "core/surface/measured_summary.h"
#include "core/surface/spectrum.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// C(q_k) = a_k^2 / (4 dq), so that h^2 = 2 sum C dq.
Json spectrumJson(const FourierLine& modes) {
  Json waves = Json::array(), densities = Json::array();
  const double lowest = 2 * std::numbers::pi / modes.length;
  for (std::size_t j = 0; j < modes.coefficients.size(); ++j) {
    waves.push_back(lowest * static_cast<double>(j + 1));
    densities.push_back(std::norm(modes.coefficients[j]) / lowest);
  }
  return {{"wave_number", std::move(waves)}, {"power_spectral_density", std::move(densities)}};
}

}  // namespace

std::string lineCsv(const Line& line) {
  std::string text = joinedColumns({"position", "height"}) + "\n";
  for (std::size_t i = 0; i < line.nodes(); ++i)
    text += fmt::format("{},{}\n", static_cast<double>(i) * line.spacing, line.height[i]);
  return text;
}

DataTable spectrumTable(const LineSource& source) {
  DataTable table{{ColumnName("wave_number").text(), ColumnName("power_spectral_density").text()},
                  {}};
  const FourierLine modes = source.spectrum(0);
  const double lowest = 2 * std::numbers::pi / modes.length;
  for (std::size_t j = 0; j < modes.coefficients.size(); ++j)
    table.rows.push_back(
        {lowest * static_cast<double>(j + 1), std::norm(modes.coefficients[j]) / lowest});
  return table;
}

DataTable statisticsTable(const Scene& scene, const LineSource& source, const Line& line) {
  const auto [lowest, highest] = std::minmax_element(line.height.begin(), line.height.end());
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  DataTable table{{ColumnName("quantity").text(), ColumnName("unit").text(),
                   ColumnName("value").text(), ColumnName("raw").text()},
                  {}};
  const auto add = [&](const char* name, const char* unit, TableCell value) {
    table.rows.push_back({std::string(name), std::string(unit), std::move(value), kNone});
  };
  add("length", "m", line.length);
  add("points", "", static_cast<std::int64_t>(line.nodes()));
  add("spacing", "m", line.spacing);
  add("rms_height", "m", line.rmsHeight);
  add("rms_slope", "", line.rmsSlope);
  add("lowest", "m", *lowest);
  add("highest", "m", *highest);
  if (source.measured())
    for (const NamedValue& value : namedValues(measuredSummary(scene, source)))
      table.rows.push_back({value.name, value.unit, value.used, value.raw});
  return table;
}

std::string surfaceJson(const Scene& scene, const LineSource& source, const Line& line) {
  const auto [lowest, highest] = std::minmax_element(line.height.begin(), line.height.end());
  Json root = provenance("surface", scene);
  root["statistics"] = {{"length", line.length},      {"points", line.nodes()},
                        {"spacing", line.spacing},    {"rms_height", line.rmsHeight},
                        {"rms_slope", line.rmsSlope}, {"lowest", *lowest},
                        {"highest", *highest}};
  const FourierLine modes = source.spectrum(0);
  root["spectrum"] = modes.coefficients.empty() ? Json(nullptr) : spectrumJson(modes);
  if (source.measured()) addTo(root, measuredSummary(scene, source));
  for (const Message& fact : source.spectrumFacts())
    root["reading"]["facts"].push_back(fact.english());
  return root.dump(2) + "\n";
}

}  // namespace asperity
