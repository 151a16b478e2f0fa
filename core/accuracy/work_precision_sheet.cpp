#include "core/accuracy/work_precision_sheet.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/scene/columns.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "core/surface/line_source.h"
#include "core/surface/measured_summary.h"
#include "core/surface/surface_file.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

const WorkPrecisionPoint* findPoint(const RegionPrecision& region, const MethodChoice& choice) {
  const auto found =
      std::find_if(region.points.begin(), region.points.end(),
                   [&](const WorkPrecisionPoint& point) { return point.choice == choice; });
  return found == region.points.end() ? nullptr : &*found;
}

DiagramSeries methodSeries(const RegionPrecision& region, Method method, const char* name,
                           SeriesMark mark, int colour) {
  DiagramSeries series{.name = name, .mark = mark, .colour = colour};
  for (const WorkPrecisionPoint& point : region.points)
    if (point.choice.method == method)
      series.points.push_back({point.secondsWithLine, point.error});
  return series;
}

DiagramSeries frontSeries(const RegionPrecision& region) {
  std::vector<WorkPrecisionPoint> front;
  for (const WorkPrecisionPoint& point : region.points)
    if (point.isOnFront) front.push_back(point);
  std::sort(front.begin(), front.end(),
            [](const auto& a, const auto& b) { return a.secondsWithLine < b.secondsWithLine; });
  DiagramSeries series{
      .name = "best for the time", .stroke = SeriesStroke::Dashed, .isTheory = true};
  for (const WorkPrecisionPoint& point : front)
    series.points.push_back({point.secondsWithLine, point.error});
  return series;
}

/// Returns "cubic \u00D72".
Message printedName(const MethodChoice& choice) {
  switch (choice.method) {
    case Method::Linear:
      return message("linear \u00D7{}", choice.oversampling);
    case Method::Cubic:
      return message("cubic \u00D7{}", choice.oversampling);
    default:
      return methodName(choice);
  }
}

/// Returns a ring around the scene's present method.
DiagramSeries presentSeries(const WorkPrecisionPoint& present) {
  DiagramSeries series{.name = message("this scene: {}", printedName(present.choice)),
                       .mark = SeriesMark::Ring,
                       .stroke = SeriesStroke::None};
  series.isTheory = true;  // drawn in the colour of texts, which no method has
  series.points = {{present.secondsWithLine, present.error}};
  return series;
}

Diagram regionDiagram(const WorkPrecision& comparison, const RegionPrecision& region) {
  Diagram diagram{
      .title = message("region {}: {} to {} m/s", region.region,
                       printed(region.velocities.front(), 2), printed(region.velocities.back(), 2)),
      .x = {"time of one velocity", "s"},
      .y = {"relative error of \u03BC", ""}};
  diagram.series = {
      frontSeries(region),
      methodSeries(region, Method::Literal, "literal march (difference)", SeriesMark::Square, 0),
      methodSeries(region, Method::Nodal, "nodal (difference)", SeriesMark::Diamond, 1),
      methodSeries(region, Method::Linear, "linear \u00D71 to \u00D716", SeriesMark::Triangle, 4),
      methodSeries(region, Method::Cubic, "cubic \u00D71 to \u00D716", SeriesMark::Circle, 2)};
  // A method that cannot compute this scene has no points, and no entry in the legend.
  std::erase_if(diagram.series, [](const DiagramSeries& series) { return series.points.empty(); });
  if (const WorkPrecisionPoint* present = findPoint(region, comparison.present))
    diagram.series.push_back(presentSeries(*present));
  const double target = comparison.scene.accuracy.targetRelativeError;
  if (target > 0) {
    DiagramSeries line{.name = message("target {}", printed(target)),
                       .stroke = SeriesStroke::Dotted,
                       .isTheory = true};
    double fastest = region.points.front().secondsWithLine, slowest = fastest;
    for (const WorkPrecisionPoint& point : region.points) {
      fastest = std::min(fastest, point.secondsWithLine);
      slowest = std::max(slowest, point.secondsWithLine);
    }
    line.points = {{fastest, target}, {slowest, target}};
    diagram.series.push_back(std::move(line));
  }
  return diagram;
}

/// Returns the seconds for one more line at one velocity, with the scene's present method.
double secondsOfLine(const WorkPrecision& comparison, const RegionPrecision& region) {
  const WorkPrecisionPoint* present = findPoint(region, comparison.present);
  if (!present) return kNotApplicable;
  return present->secondsWithLine;
}

Diagram spreadDiagram(const WorkPrecision& comparison, bool overSeconds) {
  Diagram diagram;
  diagram.title = overSeconds ? "against time" : "against realizations";
  diagram.x =
      overSeconds ? DiagramAxis{"time of one velocity", "s"} : DiagramAxis{"realizations", ""};
  diagram.y = {"relative standard error of \u03BC", ""};
  int colour = 0;
  for (const RegionPrecision& region : comparison.regions) {
    const double each = overSeconds ? secondsOfLine(comparison, region) : 1;
    DiagramSeries measured{.name = message("region {}", region.region),
                           .mark = SeriesMark::Circle,
                           .stroke = SeriesStroke::None};
    DiagramSeries law;
    measured.colour = law.colour = colour++;
    law.stroke = SeriesStroke::Dashed;
    for (std::size_t k = 0; k < region.lineCounts.size(); ++k) {
      const auto lines = static_cast<double>(region.lineCounts[k]);
      measured.points.push_back({each * lines, region.standardErrors[k]});
      law.points.push_back({each * lines, region.standardErrors[0] / std::sqrt(lines)});
    }
    diagram.series.push_back(std::move(law));
    diagram.series.push_back(std::move(measured));
  }
  return diagram;
}

Message comparisonSubtitle(const WorkPrecision& comparison) {
  const Scene& scene = comparison.scene;
  const std::int64_t elements = LineSource(scene, 1).elements();
  const Message lines =
      comparison.lines == 1
          ? message("1 line of {} elements, 8 velocities in each region", elements)
          : message("{} lines of {} elements, 8 velocities in each region", comparison.lines,
                    elements);
  return scene.title.empty() ? lines : message("{}; {}", Message(scene.title), lines);
}

}  // namespace

std::string workPrecisionCsv(const WorkPrecision& comparison) {
  DataTable table{columnNames({"region", "velocity_from", "velocity_to", "method", "oversampling",
                               "relative_error", "largest_error", "is_model_difference", "seconds",
                               "seconds_lower_quartile", "seconds_upper_quartile", "line_seconds",
                               "seconds_with_line", "is_extrapolated", "is_on_front",
                               "is_present_choice", "reference_error"}),
                  {}};
  const auto flag = [](bool is) { return std::int64_t{is}; };
  for (const RegionPrecision& region : comparison.regions)
    for (const WorkPrecisionPoint& point : region.points)
      table.rows.push_back({region.region, region.velocities.front(), region.velocities.back(),
                            std::string(methodWord(point.choice.method)), point.choice.oversampling,
                            point.error, point.largest, flag(point.isDifference), point.seconds,
                            point.lowerQuartile, point.upperQuartile, point.lineSeconds,
                            point.secondsWithLine, flag(point.isExtrapolated),
                            flag(point.isOnFront), flag(point.choice == comparison.present),
                            region.referenceError});
  return tableCsv(table);
}

std::string workPrecisionJson(const WorkPrecision& comparison) {
  Json root = provenance("accuracy", comparison.scene);
  addReadingFacts(root, readingFacts(comparison.scene));
  root["present_choice"] = methodName(comparison.present);
  root["lines"] = comparison.lines;
  Json regions = Json::array();
  for (const RegionPrecision& region : comparison.regions) {
    Json entry = {{"region", region.region},
                  {"velocities", region.velocities},
                  {"reference_error", region.referenceError}};
    Json points = Json::array();
    for (const WorkPrecisionPoint& point : region.points)
      points.push_back({{"method", methodName(point.choice)},
                        {"relative_error", numberOrNull(point.error)},
                        {"largest_error", numberOrNull(point.largest)},
                        {"is_model_difference", point.isDifference},
                        {"seconds", point.seconds},
                        {"seconds_quartiles", {point.lowerQuartile, point.upperQuartile}},
                        {"line_seconds", point.lineSeconds},
                        {"seconds_with_line", point.secondsWithLine},
                        {"is_extrapolated", point.isExtrapolated},
                        {"is_on_front", point.isOnFront}});
    entry["methods"] = std::move(points);
    entry["realizations"] = region.lineCounts;
    entry["relative_standard_errors"] = region.standardErrors;
    entry["march"] = {{"time_step", numberOrNull(region.timeStepError)},
                      {"settling", numberOrNull(region.settlingError)}};
    regions.push_back(std::move(entry));
  }
  root["regions"] = std::move(regions);
  return jsonFile(root);
}

DiagramSheet workPrecisionSheet(const WorkPrecision& comparison) {
  DiagramSheet sheet{.title = "What accuracy costs in time",
                     .subtitle = comparisonSubtitle(comparison)};
  for (const RegionPrecision& region : comparison.regions)
    sheet.diagrams.push_back(regionDiagram(comparison, region));
  sheet.columns = sheet.diagrams.size() > 3 ? 2 : 0;
  sheet.note =
      "Errors against cubic at two high resolutions, extrapolated. The literal march and nodal are "
      "other models at the smallest scale: theirs is a difference, not an error. Processor time of "
      "one thread, medians of repeated runs, with the share of one velocity of the sweep in making "
      "the line.";
  return sheet;
}

DiagramSheet standardErrorSheet(const WorkPrecision& comparison) {
  DiagramSheet sheet{
      .title = "What realizations cost in time",
      .subtitle = listed({comparisonSubtitle(comparison), printedName(comparison.present)}),
      .diagrams = {spreadDiagram(comparison, false), spreadDiagram(comparison, true)}};
  sheet.note =
      "Circles: spread of the means over groups of so many lines. Lines: one over the square root.";
  return sheet;
}

}  // namespace asperity
