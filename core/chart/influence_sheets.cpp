#include "core/chart/influence_sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/chart/curve_words.h"
#include "core/friction/curve_file.h"
#include "core/scene/columns.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

DataTable sensitivityTable(const std::vector<Exponent>& all) {
  DataTable table{columnNames({"key", "value", "mu_exponent", "mu_exponent_standard_error"}), {}};
  for (const Exponent& one : all)
    table.rows.push_back(
        {std::string(one.key), one.value, one.exponent.value, one.exponent.standardError});
  return table;
}

DataTable cutoffTable(const std::vector<CutoffPoint>& points) {
  std::vector<CurvePoint> states;
  for (const CutoffPoint& point : points) states.push_back(point.state);
  const CurveTable curve(states, {});
  DataTable table{curve.header(columnNames(
                      {"cutoff_wavelength", "share_of_decade", "share_of_decade_standard_error"})),
                  {}};
  for (const CutoffPoint& point : points)
    table.rows.push_back(curve.row(point.state, {point.wavelength, point.shareOfDecade.value,
                                                 point.shareOfDecade.standardError}));
  return table;
}

DiagramAxis wavelengthAxis() {
  return {"short-wave cut-off \u03BB", "m", AxisScale::Logarithmic};
}

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
  DiagramSheet sheet{.title = "What friction depends on", .subtitle = describeScene(scene)};
  Diagram diagram{.x = {"exponent d ln \u03BC / d ln (parameter)", "", AxisScale::Linear},
                  .y = {"", "", AxisScale::Linear}};
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
      "Lines: one standard error, with an arrow where it goes on. Pale: smaller than its error.",
      printed(scene.sliding.velocity));
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
  return tableCsv(sensitivityTable(all));
}

std::string sensitivityJson(const Scene& scene, const std::vector<Exponent>& all) {
  Json root = provenance("sensitivity", scene);
  root["parameters"] = tableJson(sensitivityTable(all));
  return jsonFile(root);
}

DiagramSheet cutoffSheet(const Scene& scene, const std::vector<CutoffPoint>& points) {
  DiagramSheet sheet{.title = "Friction against the short-wave cut-off",
                     .subtitle = describeScene(scene),
                     .columns = 1,
                     .sharesAxis = true};
  Diagram friction, share;
  friction.x = share.x = wavelengthAxis();
  friction.y = {"coefficient of friction \u03BC", "", AxisScale::Logarithmic};
  share.y = {"share of friction per decade", "", AxisScale::Linear};
  share.height = 0.7;
  DiagramSeries mu, shares, zero;
  mu.mark = shares.mark = SeriesMark::Circle;
  mu.colour = 0;
  shares.colour = 1;
  zero.isTheory = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CurvePoint& state = points[i].state;
    mu.points.push_back(
        pointWithError(points[i].wavelength, state.mu, state.muStandardError, static_cast<int>(i)));
    if (i == 0) continue;
    // The step belongs to the waves between its two cut-offs.
    const double middle = std::sqrt(points[i - 1].wavelength * points[i].wavelength);
    const Estimate& part = points[i].shareOfDecade;
    shares.points.push_back(
        pointWithError(middle, part.value, part.standardError, static_cast<int>(i)));
    zero.points.push_back({middle, 0});
  }
  friction.series = {std::move(mu)};
  share.series = {std::move(zero), std::move(shares)};
  if (!points.empty()) {
    for (DiagramAxis* axis : {&friction.x, &share.x}) {
      axis->from = points.back().wavelength / kLogMargin;
      axis->to = points.front().wavelength * kLogMargin;
    }
  }
  sheet.diagrams = {std::move(friction), std::move(share)};
  sheet.note =
      "Friction of the same lines without their waves shorter than \u03BB, and the share of it "
      "that the waves of one decade of wavelengths make.";
  return sheet;
}

std::vector<Message> describeCutoff(const std::vector<CutoffPoint>& points) {
  constexpr double kNegligible = 0.1;  // share of a decade
  std::vector<Message> lines;
  if (points.size() < 2) return lines;
  const double half = points.back().state.mu / 2;
  if (!(half > 0)) return lines;
  // From the whole line on towards longer waves, to the first point with less than half.
  for (std::size_t i = points.size() - 1; i > 0; --i) {
    const CutoffPoint &shorter = points[i], &longer = points[i - 1];
    if (longer.state.mu > half) continue;
    const double part = (half - longer.state.mu) / (shorter.state.mu - longer.state.mu);
    const double wavelength =
        longer.wavelength * std::pow(shorter.wavelength / longer.wavelength, part);
    lines.push_back(
        message("without waves shorter than {} friction of deformation is half as large",
                printed(wavelength, "m", 2)));
    break;
  }
  const double share = points.back().shareOfDecade.value;
  if (std::isfinite(share) && share > kNegligible)
    lines.push_back(
        message("at the shortest waves of the line, one decade of wavelengths makes {} % of "
                "friction: shorter waves, which the line does not have, would change it",
                printedPercent(share, 2)));
  return lines;
}

std::string cutoffCsv(const std::vector<CutoffPoint>& points) {
  return tableCsv(cutoffTable(points));
}

std::string cutoffJson(const Scene& scene, const std::vector<CutoffPoint>& points) {
  Json root = provenance("cutoff", scene);
  root["points"] = tableJson(cutoffTable(points));
  return jsonFile(root);
}

}  // namespace asperity
