#include "core/study/study_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/friction/curve_file.h"
#include "core/scene/columns.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

std::string joined(const std::vector<std::string>& cells) {
  return fmt::format("{}\n", fmt::join(cells, ","));
}

}  // namespace

std::string axisName(const StudyAxis& axis) {
  return axis.columns.size() == 1 ? std::string(axis.columns.front().key()) : "rows";
}

Json analysisJson(const ParameterStudy& study, const StudyAnalysis& analysis) {
  Json outputs = Json::array(), bands = Json::array();
  for (const OutputAnalysis& output : analysis.outputs) {
    Json percentiles = Json::object(), indices = Json::array(), correlations = Json::array();
    for (std::size_t i = 0; i < kPercentiles.size(); ++i)
      percentiles[fmt::format("{}", kPercentiles[i])] = numberOrNull(output.percentiles[i]);
    for (const SobolIndex& index : output.indices)
      indices.push_back({{"key", axisName(study.space.axes()[index.axis])},
                         {"first_order", numberOrNull(index.first.value)},
                         {"first_order_standard_error", numberOrNull(index.first.standardError)},
                         {"total_effect", numberOrNull(index.total.value)},
                         {"total_effect_standard_error", numberOrNull(index.total.standardError)}});
    for (const ColumnEffect& effect : output.effects)
      correlations.push_back({{"key", study.space.column(effect.column).key()},
                              {"is_logarithmic", effect.isLogarithmic},
                              {"correlation", numberOrNull(effect.correlation)},
                              {"rank_correlation", numberOrNull(effect.rankCorrelation)}});
    outputs.push_back({{"name", output.name},
                       {"count", output.count},
                       {"failed", output.failed},
                       {"mean", numberOrNull(output.mean)},
                       {"deviation", numberOrNull(output.deviation)},
                       {"least", numberOrNull(output.least)},
                       {"largest", numberOrNull(output.largest)},
                       {"percentiles", std::move(percentiles)},
                       {"sobol_indices", std::move(indices)},
                       {"blocks", output.blocks},
                       {"correlations", std::move(correlations)}});
  }
  for (const CurveBand& band : analysis.bands) bands.push_back(band.name);
  return {{"simulations", analysis.simulations},
          {"sampled", analysis.sampled},
          {"outputs", std::move(outputs)},
          {"bands", std::move(bands)}};
}

std::string indicesCsv(const ParameterStudy& study, const StudyAnalysis& analysis) {
  std::string text = joinedColumns({"output", "key", "first_order", "first_order_low",
                                    "first_order_high", "total_effect", "total_effect_low",
                                    "total_effect_high", "correlation", "rank_correlation"}) +
                     "\n";
  for (const OutputAnalysis& output : analysis.outputs) {
    const auto row = [&](const std::string& key, const SobolIndex* index,
                         const ColumnEffect* effect) {
      std::vector<std::string> cells{output.name, key};
      for (const Estimate& estimate :
           {index ? index->first : Estimate{}, index ? index->total : Estimate{}}) {
        const double half = kHalfInterval * estimate.standardError;
        for (const double value : {estimate.value, estimate.value - half, estimate.value + half})
          cells.push_back(csvNumber(value));
      }
      cells.push_back(csvNumber(effect ? effect->correlation : kNotApplicable));
      cells.push_back(csvNumber(effect ? effect->rankCorrelation : kNotApplicable));
      text += joined(cells);
    };
    std::size_t column = 0;
    for (std::size_t a = 0; a < study.space.axes().size(); ++a) {
      const StudyAxis& axis = study.space.axes()[a];
      const SobolIndex* index = a < output.indices.size() ? &output.indices[a] : nullptr;
      if (axis.columns.size() > 1) row("rows", index, nullptr);
      for (const StudyColumn& one : axis.columns)
        row(std::string(one.key()), axis.columns.size() == 1 ? index : nullptr,
            &output.effects[column++]);
    }
  }
  return text;
}

std::string effectsCsv(const ParameterStudy& study, const StudyAnalysis& analysis) {
  std::string text =
      joinedColumns({"output", "key", "key_value", "mean", "mean_standard_error", "count"}) + "\n";
  for (const OutputAnalysis& output : analysis.outputs)
    for (const ColumnEffect& effect : output.effects)
      for (const MainEffect& one : effect.means)
        text += joined(
            {output.name, std::string(study.space.column(effect.column).key()),
             study.space.column(effect.column).hasWords() ? study.textAt(effect.column, one.x)
                                                          : csvNumber(one.x),
             csvNumber(one.mean), csvNumber(one.standardError), std::to_string(one.count)});
  return text;
}

std::string percentilesCsv(const StudyAnalysis& analysis) {
  std::string text = joinedColumns({"output", "sweep_value", "percentile_5", "percentile_25",
                                    "percentile_50", "percentile_75", "percentile_95"}) +
                     "\n";
  const auto row = [&](const std::string& name, double at, const auto& percentiles) {
    std::vector<std::string> cells{name, csvNumber(at)};
    for (const double value : percentiles) cells.push_back(csvNumber(value));
    text += joined(cells);
  };
  for (const OutputAnalysis& output : analysis.outputs)
    row(output.name, kNotApplicable, output.percentiles);
  for (const CurveBand& band : analysis.bands)
    for (std::size_t v = 0; v < band.values.size(); ++v)
      row(band.name, band.values[v], band.percentiles[v]);
  return text;
}

}  // namespace asperity
