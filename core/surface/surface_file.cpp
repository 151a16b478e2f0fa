#include "core/surface/surface_file.h"

#include <fmt/format.h>

#include <algorithm>
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
  return root.dump(2) + "\n";
}

}  // namespace asperity
