#include "core/study/study_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/intervals.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/chart/map_sheet.h"
#include "core/friction/curve_file.h"
#include "core/scene/columns.h"
#include "core/scene/data_table.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

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
  DataTable table{columnNames({"output", "key", "first_order", "first_order_low",
                               "first_order_high", "total_effect", "total_effect_low",
                               "total_effect_high", "correlation", "rank_correlation"}),
                  {}};
  for (const OutputAnalysis& output : analysis.outputs) {
    const auto add = [&](const std::string& key, const SobolIndex& index,
                         const ColumnEffect& effect) {
      const double first = index.halfInterval * index.first.standardError;
      const double total = index.halfInterval * index.total.standardError;
      table.rows.push_back({output.name, key, index.first.value, index.first.value - first,
                            index.first.value + first, index.total.value, index.total.value - total,
                            index.total.value + total, effect.correlation, effect.rankCorrelation});
    };
    std::size_t column = 0;
    for (std::size_t a = 0; a < study.space.axes().size(); ++a) {
      const StudyAxis& axis = study.space.axes()[a];
      const SobolIndex index = a < output.indices.size() ? output.indices[a] : SobolIndex{};
      if (axis.columns.size() > 1) add("rows", index, {});
      for (const StudyColumn& one : axis.columns)
        add(std::string(one.key()), axis.columns.size() == 1 ? index : SobolIndex{},
            output.effects[column++]);
    }
  }
  return tableCsv(table);
}

std::string effectsCsv(const ParameterStudy& study, const StudyAnalysis& analysis) {
  DataTable table{
      columnNames({"output", "key", "key_value", "mean", "mean_standard_error", "count"}), {}};
  for (const OutputAnalysis& output : analysis.outputs)
    for (const ColumnEffect& effect : output.effects) {
      const StudyColumn& column = study.space.column(effect.column);
      for (const MainEffect& one : effect.means) {
        const TableCell value =
            column.hasWords() ? TableCell(study.textAt(effect.column, one.x)) : TableCell(one.x);
        table.rows.push_back({output.name, std::string(column.key()), value, one.mean,
                              one.standardError, one.count});
      }
    }
  return tableCsv(table);
}

std::string percentilesCsv(const StudyAnalysis& analysis) {
  DataTable table{columnNames({"output", "sweep_value", "percentile_5", "percentile_25",
                               "percentile_50", "percentile_75", "percentile_95"}),
                  {}};
  const auto add = [&](const std::string& name, double at, const auto& percentiles) {
    std::vector<TableCell>& row = table.rows.emplace_back(std::vector<TableCell>{name, at});
    row.insert(row.end(), percentiles.begin(), percentiles.end());
  };
  for (const OutputAnalysis& output : analysis.outputs)
    add(output.name, kNotApplicable, output.percentiles);
  for (const CurveBand& band : analysis.bands)
    for (std::size_t v = 0; v < band.values.size(); ++v)
      add(band.name, band.values[v], band.percentiles[v]);
  return tableCsv(table);
}

namespace {

constexpr std::size_t kMaxDots = 1500;  // of one diagram of scattered points

/// Every axis or column gets a position 1, 2, ... with its name above it.
void addNames(Diagram& diagram, const std::vector<std::string>& names,
              const std::vector<std::string>& shortNames) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    DiagramSpan span;
    span.from = static_cast<double>(i) + 0.5;
    span.to = span.from + 1;
    span.label = Message(names[i]);
    span.shortLabel = shortNames[i];
    diagram.spans.push_back(std::move(span));
  }
  diagram.x = {"parameter", "", AxisScale::Linear, 0.5, static_cast<double>(names.size()) + 0.5,
               true};
}

/// Returns the label of a key, and its symbol.
std::string keyLabel(const StudyColumn& column) {
  return std::string(column.row->label);
}
std::string shortLabel(const StudyColumn& column) {
  return std::string(column.row->symbol.empty() ? column.row->label : column.row->symbol);
}

/// Returns the axis of an output; one that no curve has as a column keeps its name.
DiagramAxis quantityAxis(std::string_view name) {
  return {mapQuantityTitle(name), std::string(mapQuantityUnit(name)), AxisScale::Linear};
}

/// Returns the column of a curve: "mu" of "curve.mu".
std::string columnOf(const CurveBand& band) {
  return band.name.substr(band.name.find('.') + 1);
}

DiagramSheet sensitivitySheet(const ParameterStudy& study, const StudyAnalysis& analysis) {
  DiagramSheet sheet;
  sheet.title = "Which parameter is responsible for the scatter";
  sheet.note =
      "First order: the share of the variance that goes where the parameter is known. Total: the "
      "share that stays where all others are known. Bars: 95 % confidence.";
  std::vector<std::string> names, shortNames;
  for (const StudyAxis& axis : study.space.axes()) {
    const bool isSingle = axis.columns.size() == 1;
    names.push_back(isSingle ? keyLabel(axis.columns.front()) : "rows");
    shortNames.push_back(isSingle ? shortLabel(axis.columns.front()) : "rows");
  }
  for (const OutputAnalysis& output : analysis.outputs) {
    if (output.indices.empty()) continue;
    Diagram diagram;
    diagram.title = mapQuantityTitle(output.name);
    addNames(diagram, names, shortNames);
    diagram.y = {"share of the variance", "", AxisScale::Linear};
    DiagramSeries first{
        .name = "first order", .mark = SeriesMark::Circle, .stroke = SeriesStroke::None};
    DiagramSeries total{.name = "total", .mark = SeriesMark::Square, .stroke = SeriesStroke::None};
    for (const SobolIndex& index : output.indices) {
      constexpr double kAside = 0.12;
      const double x = static_cast<double>(index.axis) + 1;
      const auto point = [&index](double at, const Estimate& estimate) {
        return pointWithError(at, estimate.value, index.halfInterval * estimate.standardError);
      };
      first.points.push_back(point(x - kAside, index.first));
      total.points.push_back(point(x + kAside, index.total));
    }
    diagram.series = {std::move(first), std::move(total)};
    sheet.diagrams.push_back(std::move(diagram));
  }
  return sheet;
}

DiagramSheet correlationSheet(const ParameterStudy& study, const StudyAnalysis& analysis) {
  DiagramSheet sheet;
  sheet.title = "Correlation of the results with the parameters";
  sheet.note =
      "Correlation of the values (of the logarithm where a key is varied over it) and of their "
      "ranks; 1 and \u22121 mean that the parameter decides alone.";
  for (const OutputAnalysis& output : analysis.outputs) {
    Diagram diagram;
    diagram.title = mapQuantityTitle(output.name);
    std::vector<std::string> names, shortNames;
    DiagramSeries values{
        .name = "of the values", .mark = SeriesMark::Circle, .stroke = SeriesStroke::None};
    DiagramSeries ranks{
        .name = "of the ranks", .mark = SeriesMark::Diamond, .stroke = SeriesStroke::None};
    for (const ColumnEffect& effect : output.effects) {
      const StudyColumn& column = study.space.column(effect.column);
      if (column.hasWords()) continue;  // words have no order
      names.push_back(keyLabel(column));
      shortNames.push_back(shortLabel(column));
      const auto x = static_cast<double>(names.size());
      values.points.push_back({x - 0.1, effect.correlation});
      ranks.points.push_back({x + 0.1, effect.rankCorrelation});
    }
    if (names.empty()) continue;
    addNames(diagram, names, shortNames);
    diagram.y = {"correlation", "", AxisScale::Linear, -1.05, 1.05};
    diagram.series = {std::move(values), std::move(ranks)};
    sheet.diagrams.push_back(std::move(diagram));
  }
  return sheet;
}

DiagramSheet effectsSheet(const ParameterStudy& study, const OutputAnalysis& output) {
  DiagramSheet sheet;
  sheet.title = message("{} over each parameter", mapQuantityTitle(output.name));
  sheet.note =
      "Points: single simulations. Line: mean over all other parameters, with its standard error.";
  for (const ColumnEffect& effect : output.effects) {
    const StudyColumn& column = study.space.column(effect.column);
    Diagram diagram{.x = {Message(column.row->label), std::string(column.row->unit),
                          effect.isLogarithmic ? AxisScale::Logarithmic : AxisScale::Linear},
                    .y = quantityAxis(output.name)};
    DiagramSeries single{.name = "single simulations",
                         .mark = SeriesMark::Circle,
                         .stroke = SeriesStroke::None,
                         .isFaded = true};
    DiagramSeries mean;
    const std::size_t step = effect.sample.size() / kMaxDots + 1;
    for (std::size_t i = 0; i < effect.sample.size(); i += step)
      single.points.push_back({effect.sample[i].first, effect.sample[i].second});
    mean.name = "mean";
    mean.isBand = true;
    mean.colour = 1;
    for (const MainEffect& one : effect.means)
      mean.points.push_back(pointWithError(one.x, one.mean, one.standardError));
    diagram.series = {std::move(single), std::move(mean)};
    sheet.diagrams.push_back(std::move(diagram));
  }
  return sheet;
}

DiagramSheet bandSheet(const ParameterStudy& study, const CurveBand& band) {
  DiagramSheet sheet;
  const Parameter& row = *findParameter(study.base.sweep.key);
  sheet.title = message("{} with its scatter", mapQuantityTitle(columnOf(band)));
  sheet.note = "Bands: from the 5th to the 95th, and from the 25th to the 75th percentile.";
  Diagram diagram;
  const bool isLogarithmic = study.base.sweep.scale == SweepScale::Logarithmic;
  diagram.x = {Message(row.label), std::string(row.unit),
               isLogarithmic ? AxisScale::Logarithmic : AxisScale::Linear};
  diagram.y = quantityAxis(columnOf(band));
  const auto series = [&](const Message& name, std::size_t low, std::size_t high, bool isBand) {
    DiagramSeries one{.name = name, .isBand = isBand, .colour = 0};
    if (isBand) one.stroke = SeriesStroke::None;
    for (std::size_t v = 0; v < band.values.size(); ++v) {
      const auto& at = band.percentiles[v];
      if (isBand)
        one.points.push_back({band.values[v], at[2], at[low], at[high]});
      else
        one.points.push_back({band.values[v], at[2]});
    }
    return one;
  };
  diagram.series = {series("5 % to 95 %", 0, 4, true), series("25 % to 75 %", 1, 3, true),
                    series("median", 2, 2, false)};
  Extent extent;
  for (const auto& at : band.percentiles)
    if (at[0] > 0) {
      extent.add(at[0]);
      extent.add(at[4]);
    }
  constexpr double kWide = 30;
  if (extent.most > kWide * extent.least) diagram.y.scale = AxisScale::Logarithmic;
  sheet.diagrams = {std::move(diagram)};
  return sheet;
}

}  // namespace

std::vector<NamedSheet> studySheets(const ParameterStudy& study, const StudyAnalysis& analysis) {
  std::vector<NamedSheet> sheets;
  const auto add = [&](std::string name, DiagramSheet sheet) {
    std::ranges::replace(name, '.', '_');
    if (!study.title.empty() && sheet.subtitle.empty()) sheet.subtitle = Message::name(study.title);
    if (!sheet.diagrams.empty()) sheets.push_back({std::move(name), std::move(sheet)});
  };
  add("sensitivity", sensitivitySheet(study, analysis));
  add("correlation", correlationSheet(study, analysis));
  for (const OutputAnalysis& output : analysis.outputs)
    if (output.count > 0) add("effects_" + output.name, effectsSheet(study, output));
  for (const CurveBand& band : analysis.bands)
    add("band_" + columnOf(band), bandSheet(study, band));
  return sheets;
}

}  // namespace asperity
