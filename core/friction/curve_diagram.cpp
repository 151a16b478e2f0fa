#include "core/friction/curve_diagram.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "core/friction/with_unit.h"
#include "core/scene/parameters.h"

namespace asperity {
namespace {

/// The table's symbols in the letters of a printed text.
std::string printed(std::string_view symbol) {
  constexpr std::pair<std::string_view, std::string_view> letters[] = {{"tau", "\u03C4"},
                                                                       {"eta", "\u03B7"},
                                                                       {"kappa", "\u03BA"},
                                                                       {"lambda_r", "\u03BB_r"},
                                                                       {"G_inf", "G_\u221E"}};
  for (const auto& [word, letter] : letters)
    if (symbol == word) return std::string(letter);
  return std::string(symbol);
}

/// Empty where the row has no symbol, or the effect is not there.
std::string inWords(const Parameter& row, const Scene& scene) {
  if (row.symbol.empty() || !isApplicable(row, scene)) return {};
  const ParameterValue value = valueOf(row, scene);
  const auto* real = std::get_if<double>(&value);
  const auto* whole = std::get_if<std::int64_t>(&value);
  if (real && *real == 0 && value == defaultOf(row)) return {};
  if (real && row.unit.empty()) return fmt::format("{} = {:g}", printed(row.symbol), *real);
  if (real) return fmt::format("{} = {}", printed(row.symbol), withUnit(*real, row.unit));
  if (whole && *whole > 0) return fmt::format("{} = {}", printed(row.symbol), *whole);
  return {};
}

std::string nameOfMean(const CurvePoint& point) {
  if (point.realizations <= 1) return "this line";
  return fmt::format("mean of {} lines \u00B1 standard error", point.realizations);
}

/// Of the temperature nothing is said where it shifts nothing.
bool isShiftIdle(const Parameter& row, const Scene& scene) {
  const bool shifts = row.key == "elastomer.temperature" || row.key.starts_with("elastomer.shift");
  return shifts && scene.elastomer.temperature == scene.elastomer.shift.referenceTemperature;
}

}  // namespace

std::string parametersInWords(const Scene& scene) {
  std::vector<std::string> parts;
  for (const Parameter& row : parameters()) {
    if (row.key.starts_with("sliding.") || isShiftIdle(row, scene)) continue;
    if (std::string words = inWords(row, scene); !words.empty()) parts.push_back(std::move(words));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

DiagramSheet curveSheet(const Scene& scene, std::span<const CurvePoint> points) {
  DiagramSeries mean, law;
  law.name = "Eq. (11)";
  law.isTheory = true;
  mean.mark = SeriesMark::Circle;
  if (!points.empty()) mean.name = nameOfMean(points.front());
  bool hasLaw = false;
  for (const CurvePoint& point : points) {
    const double error = point.muStandardError;
    mean.points.push_back({point.velocity, point.mu, point.mu - error, point.mu + error});
    law.points.push_back({point.velocity, point.muLaw});
    hasLaw = hasLaw || point.muLaw > 0;
  }
  Diagram diagram;
  diagram.x = {"sliding velocity v", "m/s"};
  diagram.y = {"coefficient of friction \u03BC"};
  if (hasLaw) diagram.series.push_back(std::move(law));
  diagram.series.push_back(std::move(mean));
  DiagramSheet sheet;
  sheet.title = scene.title.empty() ? "Friction over velocity" : scene.title;
  sheet.subtitle = parametersInWords(scene);
  sheet.diagrams = {std::move(diagram)};
  return sheet;
}

}  // namespace asperity
