#include "core/chart/sensitivity_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/chart/curve_words.h"
#include "core/friction/curve_file.h"
#include "core/scene/columns.h"
#include "core/scene/provenance.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr ColumnName kKey = "key", kValue = "value", kExponent = "mu_exponent",
                     kError = "mu_exponent_standard_error";

}  // namespace

std::vector<Exponent> sensitivityExponents(const Scene& scene,
                                           const std::vector<Sensitivity>& all) {
  std::vector<Exponent> exponents;
  for (const Sensitivity& one : all) {
    const double value = VariedParameter(one.key, scene).valueIn(scene);
    const double factor = one.isLogarithmic ? 1 : value;
    exponents.push_back(
        {one.key, value, {one.slope.value * factor, one.slope.standardError * std::abs(factor)}});
  }
  std::ranges::stable_sort(exponents, {}, [](const Exponent& one) {
    return std::isfinite(one.exponent.value) ? -std::abs(one.exponent.value) : 1;
  });
  return exponents;
}

DiagramSheet sensitivitySheet(const Scene& scene, const std::vector<Exponent>& all) {
  DiagramSheet sheet;
  sheet.title = "What friction depends on";
  sheet.subtitle = describeScene(scene);
  Diagram diagram;
  diagram.x = {"exponent d ln \u03BC / d ln p", "", AxisScale::Linear};
  diagram.y = {"", "", AxisScale::Linear};
  for (const Exponent& one : all)
    if (std::isfinite(one.exponent.value))
      diagram.bars.push_back(
          {parameterTitle(one.key), one.exponent.value, one.exponent.standardError});
  // What may be 0 comes last, and the others alone set the axis: a long line of error says little.
  std::ranges::stable_partition(diagram.bars, &DiagramBar::isSignificant);
  const bool hasSignificant = !diagram.bars.empty() && diagram.bars.front().isSignificant();
  double least = 0, most = 0;
  for (const DiagramBar& bar : diagram.bars) {
    const bool counts = bar.isSignificant() || !hasSignificant;
    const double reach = counts && std::isfinite(bar.error) ? bar.error : 0;
    least = std::min(least, bar.value - reach);
    most = std::max(most, bar.value + reach);
  }
  constexpr double kAir = 0.05;
  diagram.x.from = least - kAir * (most - least);
  diagram.x.to = most + kAir * (most - least);
  if (diagram.bars.empty()) diagram.blank = "Friction changes with no parameter here.";
  sheet.diagrams = {std::move(diagram)};
  sheet.note = message(
      "At {} m/s: by how many per cent friction changes where a parameter changes by one per cent. "
      "Lines: one standard error. Pale: smaller than its error.",
      PrintedNumber{printedNumber(scene.sliding.velocity)});
  return sheet;
}

std::string sensitivityText(const std::vector<Exponent>& all,
                            const std::array<std::string, 4>& head) {
  std::size_t widest = head[0].size();
  for (const Exponent& one : all) widest = std::max(widest, one.key.size());
  std::string text =
      fmt::format("{:<{}}  {:>12}  {:>10}  {:>10}\n", head[0], widest, head[1], head[2], head[3]);
  for (const Exponent& one : all) {
    const std::string error = std::isfinite(one.exponent.standardError)
                                  ? fmt::format("{:.4f}", one.exponent.standardError)
                                  : "";
    text += fmt::format("{:<{}}  {:>12.6g}  {:>10.4f}  {:>10}\n", one.key, widest, one.value,
                        one.exponent.value, error);
  }
  return text;
}

std::string sensitivityCsv(const std::vector<Exponent>& all) {
  std::string text = joinedColumns({kKey, kValue, kExponent, kError}) + "\n";
  for (const Exponent& one : all)
    text += fmt::format("{},{},{},{}\n", one.key, one.value, csvNumber(one.exponent.value),
                        csvNumber(one.exponent.standardError));
  return text;
}

std::string sensitivityJson(const Scene& scene, const std::vector<Exponent>& all) {
  Json root = provenance("sensitivity", scene);
  Json rows = Json::array();
  for (const Exponent& one : all)
    rows.push_back({{kKey.text(), one.key},
                    {kValue.text(), one.value},
                    {kExponent.text(), numberOrNull(one.exponent.value)},
                    {kError.text(), numberOrNull(one.exponent.standardError)}});
  root["parameters"] = std::move(rows);
  return root.dump(2) + "\n";
}

}  // namespace asperity
