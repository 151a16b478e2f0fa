#include "core/chart/fit_report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/stop.h"
#include "core/chart/curve_diagram.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/scene/columns.h"
#include "core/scene/data_table.h"
#include "core/scene/parameters.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "core/scene/scene_files.h"
#include "core/surface/measured_summary.h"
#include "core/surface/surface_file.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

std::vector<MeasuredPoint> allPoints(std::span<const FrictionData> data) {
  std::vector<MeasuredPoint> points;
  for (const FrictionData& table : data)
    points.insert(points.end(), table.points.begin(), table.points.end());
  return points;
}

/// The relative error of the computed friction that follows from the errors of the parameters.
struct RelativeError {
  double velocity = 0, value = 0;
};

/// Returns the errors at all measured points, in the order of rising velocities.
std::vector<RelativeError> relativeErrors(const Fit& fit, const CurveSet& set) {
  std::vector<RelativeError> errors;
  std::size_t i = 0;
  for (const MeasuredCurve& measured : set.measured)
    for (const double velocity : measured.abscissas) {
      errors.push_back({velocity, fit.bandErrors[i] / totalMu(fit.computed[i])});
      ++i;
    }
  std::ranges::sort(errors, {}, &RelativeError::velocity);
  return errors;
}

constexpr const char* kRangeInWords =
    "ranges: one standard error to each side, by the points' errors and the spread of the lines";

PrintedNumber inUnit(const FittedParameter& parameter, double value) {
  return printed(value, findParameter(parameter.key)->unit);
}

Message withRange(const Message& name, const FittedParameter& parameter) {
  return message("{} = {}, {}", name, inUnit(parameter, parameter.value), rangeOf(parameter));
}

/// Returns the warnings, then the notes, as files and summaries list them.
std::vector<Message> allNotes(const Fit& fit) {
  std::vector<Message> all = fit.warnings;
  all.insert(all.end(), fit.notes.begin(), fit.notes.end());
  return all;
}

/// Returns the value with its range and the name that charts use.
Message labelled(const FittedParameter& parameter) {
  return withRange(Message(std::string(findParameter(parameter.key)->label)), parameter);
}

/// Returns a linear scale where a logarithmic axis would have at most one number, because it spans
/// little more than a decade.
AxisScale profileScale(const FittedParameter& parameter, const ObjectiveProfile& profile) {
  constexpr double kWide = 30;
  if (!parameter.isLogarithmic || profile.values.empty()) return AxisScale::Linear;
  const auto [low, high] = std::ranges::minmax(profile.values);
  return high > kWide * low ? AxisScale::Logarithmic : AxisScale::Linear;
}

/// Interpolates between two measured velocities, linearly in their logarithm; NaN outside of them.
double errorAt(const std::vector<RelativeError>& errors, double velocity) {
  const auto above = std::ranges::lower_bound(errors, velocity, {}, &RelativeError::velocity);
  if (above == errors.end()) return kNotApplicable;
  if (above->velocity == velocity) return above->value;
  if (above == errors.begin()) return kNotApplicable;
  const RelativeError& below = *std::prev(above);
  return std::lerp(
      below.value, above->value,
      std::log(velocity / below.velocity) / std::log(above->velocity / below.velocity));
}

}  // namespace

Message rangeOf(const FittedParameter& parameter) {
  return message("{} to {}", inUnit(parameter, parameter.low), inUnit(parameter, parameter.high));
}

nlohmann::ordered_json fitJson(const Fit& fit) {
  Json parameters = Json::array(), combinations = Json::array(), profiles = Json::array();
  for (const FittedParameter& parameter : fit.parameters)
    parameters.push_back({{"key", parameter.key},
                          {"unit", findParameter(parameter.key)->unit},
                          {"value", parameter.value},
                          {"low", parameter.low},
                          {"high", parameter.high},
                          {"is_logarithmic", parameter.isLogarithmic},
                          {"standard_error", numberOrNull(parameter.standardError)},
                          {"is_determined", parameter.isDetermined},
                          {"is_at_limit", parameter.isAtLimit}});
  for (const Combination& combination : fit.combinations) {
    Json exponents;
    for (std::size_t k = 0; k < combination.exponents.size(); ++k)
      exponents[fit.parameters[k].key] = combination.exponents[k];
    combinations.push_back({{"exponents", std::move(exponents)},
                            {"standard_error", numberOrNull(combination.standardError)}});
  }
  for (const ObjectiveProfile& profile : fit.profiles)
    profiles.push_back(
        {{"key", profile.key}, {"values", profile.values}, {"chi_squared", profile.chiSquared}});
  Json correlations = Json::array();
  for (Eigen::Index i = 0; i < fit.correlation.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < fit.correlation.cols(); ++j)
      row.push_back(numberOrNull(fit.correlation(i, j)));
    correlations.push_back(std::move(row));
  }
  return {{"parameters", std::move(parameters)},
          {"correlations", std::move(correlations)},
          {"combinations", std::move(combinations)},
          {"profiles", std::move(profiles)},
          {"chi_squared", fit.chiSquared},
          {"degrees_of_freedom", fit.degreesOfFreedom},
          {"relative_scatter", fit.relativeScatter > 0 ? Json(fit.relativeScatter) : Json()},
          {"error_scale", fit.errorScale},
          {"has_converged", fit.hasConverged},
          {"has_found_points", fit.hasFoundPoints},
          {"evaluations", fit.evaluations},
          {"notes", englishOf(allNotes(fit))}};
}

std::string fitCsv(const Fit& fit, std::span<const FrictionData> data) {
  const std::vector<MeasuredPoint> points = allPoints(data);
  DataTable table{
      columnNames({"velocity", "normal_force", "nominal_pressure", "temperature", "mu_measured",
                   "mu_error", "mu", "mu_standard_error", "mu_band", "measured_over_computed"}),
      {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double mu = totalMu(fit.computed[i]);
    // A nominal pressure was computed as a force.
    const double force =
        std::isnan(points[i].normalForce) ? fit.computed[i].normalForce : points[i].normalForce;
    table.rows.push_back({points[i].velocity, force, points[i].nominalPressure,
                          points[i].temperature, points[i].mu, points[i].muError, mu,
                          fit.computedErrors[i], fit.bandErrors[i], points[i].mu / mu});
  }
  return tableCsv(table);
}

std::vector<Message> describeFit(const Fit& fit) {
  std::vector<Message> lines;
  for (const FittedParameter& parameter : fit.parameters)
    lines.push_back(withRange(Message::name(parameter.key), parameter));
  if (fit.missesPoints || !fit.hasFoundPoints)
    lines.emplace_back(
        "the ranges are not valid: they assume that the curve follows the points, but it misses "
        "them");
  else
    lines.emplace_back(kRangeInWords);
  if (fit.relativeScatter > 0)
    lines.push_back(
        message("the points have no errors; they scatter by {:.2g} % about the fit, "
                "with {}",
                100 * fit.relativeScatter, degreesOfFreedom(fit.degreesOfFreedom)));
  else
    lines.push_back(message("\u03C7\u00B2 = {:.4g} for {}", fit.chiSquared,
                            degreesOfFreedom(fit.degreesOfFreedom)));
  std::ranges::move(allNotes(fit), std::back_inserter(lines));
  return lines;
}

DiagramSheet fitSheet(const Fit& fit, const CurveSet& set) {
  DiagramSheet sheet = curveSheet(set);
  std::vector<Message> values;
  for (const FittedParameter& parameter : fit.parameters) values.push_back(labelled(parameter));
  sheet.subtitle = message("{} (\u00B1 standard error)", listed(values));
  DiagramSeries band{.name = "fit \u00B1 standard error", .isBand = true, .colour = 0};
  const std::vector<RelativeError> errors = relativeErrors(fit, set);
  // What was fitted is friction as it is measured: with local friction (showsTotal).
  for (const CurvePoint& point : set.present.points) {
    const double mu = totalMu(point), error = mu * errorAt(errors, point.velocity);
    if (std::isfinite(error)) band.points.push_back(pointWithError(point.velocity, mu, error));
  }
  Diagram& curves = sheet.diagrams.front();
  curves.series.insert(curves.series.begin(), std::move(band));
  return sheet;
}

namespace {

/// Ends the axis of a profile above the points beside its lowest one. Its ends may be thousands of
/// times as high, and the part that tells how well the data determine the parameter would look
/// flat.
void limitRise(const std::vector<DiagramPoint>& points, DiagramAxis& axis) {
  constexpr double kLeastRise = 10, kAboveNeighbours = 4, kMargin = 0.06;
  if (points.empty()) return;
  const auto [lowest, highest] = std::ranges::minmax_element(points, {}, &DiagramPoint::y);
  double beside = lowest->y;
  if (lowest != points.begin()) beside = std::max(beside, std::prev(lowest)->y);
  if (std::next(lowest) != points.end()) beside = std::max(beside, std::next(lowest)->y);
  const double rise = std::max(kLeastRise, kAboveNeighbours * (beside - lowest->y));
  if (!(highest->y - lowest->y > rise)) return;
  axis.from = lowest->y - kMargin * rise;
  axis.to = lowest->y + rise;
}

}  // namespace

DiagramSheet profileSheet(const Fit& fit) {
  DiagramSheet sheet;
  sheet.title = "What the data say about each parameter";
  sheet.note =
      "The least sum of squares with one parameter held: flat where the data leave it open. Its "
      "points are at most one standard error apart, which holds the spread of the lines, too; the "
      "sum of squares does not.";
  const double unit = fit.errorScale * fit.errorScale;
  for (std::size_t k = 0; k < fit.profiles.size(); ++k) {
    const ObjectiveProfile& profile = fit.profiles[k];
    const Parameter& row = *findParameter(profile.key);
    Diagram diagram{
        .x = {Message(row.label), std::string(row.unit), profileScale(fit.parameters[k], profile)},
        .y = {"\u03C7\u00B2 above its minimum", "", AxisScale::Linear}};
    DiagramSeries series;
    series.mark = SeriesMark::Circle;
    for (std::size_t i = 0; i < profile.values.size(); ++i)
      series.points.push_back({profile.values[i], (profile.chiSquared[i] - fit.chiSquared) / unit});
    limitRise(series.points, diagram.y);
    diagram.series = {std::move(series)};
    DiagramMarker best{
        .label = labelled(fit.parameters[k]), .x = fit.parameters[k].value, .isFixed = true};
    diagram.marker = best;
    sheet.diagrams.push_back(std::move(diagram));
  }
  return sheet;
}

FittedCurve fitWithCurve(const Scene& scene, const std::vector<FrictionData>& data,
                         std::span<const VariedParameter> parameters, const FitOptions& options) {
  FittedCurve fitted;
  fitted.start = scene;
  fitted.hasProfiles = options.hasProfiles;
  fitted.fit = fitFriction(scene, data, parameters, options);
  CurveOptions curve{.threads = options.threads, .stop = options.stop};
  fitted.set.present = {{}, fitted.fit.scene, frictionCurve(fitted.fit.scene, curve).points, 0};
  StateOptions states{.threads = options.threads, .stop = options.stop};
  addComparisons(fitted.set, data, states);
  throwIfStopped(options.stop);
  return fitted;
}

Json fitProvenance(const Scene& start, const Fit& fit) {
  Json root = provenance("fit", fit.scene);
  // A window opens the fitted scene; the text after it is not read.
  Json fitted = std::move(root["scene"]);
  root.erase("scene");
  root["start"] = jsonValue(writeScene(start));
  root["scene"] = std::move(fitted);
  return root;
}

Json fitOptions(const std::vector<std::string>& varied, bool hasProfiles) {
  Json options = {{"vary", varied.size() == 1 ? Json(varied.front()) : Json(varied)}};
  if (!hasProfiles) options["no_profiles"] = true;
  return options;
}

std::string fitAnswer(const Scene& start, const std::vector<Message>& reading, const Fit& fit,
                      const std::vector<std::string>& varied) {
  Json answer = fitProvenance(start, fit);
  addReadingFacts(answer, reading);
  answer["vary"] = varied;
  answer["fit"] = fitJson(fit);
  return jsonFile(answer);
}

FitReport fitReport(const FittedCurve& fitted, const std::string& folder) {
  const Fit& fit = fitted.fit;
  std::vector<FrictionData> data;
  for (const MeasuredCurve& measured : fitted.set.measured) data.push_back(measured.data);
  FitReport report;
  report.reading = readingFacts(fitted.start);
  report.texts = {
      {"fit.json", fitAnswer(fitted.start, report.reading, fit, fitted.varied)},
      {"fitted.scene.json", writeScene(withFilesRelativeTo(folder, fit.scene))},
      {"fit.csv", provenanceComment(fitProvenance(fitted.start, fit)) + fitCsv(fit, data)}};
  report.sheets.push_back({"curve", fitSheet(fit, fitted.set)});
  if (!fit.profiles.empty()) report.sheets.push_back({"profiles", profileSheet(fit)});
  return report;
}

}  // namespace asperity
