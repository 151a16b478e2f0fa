#include "core/friction/parameter_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/friction/steady_states.h"
#include "core/scene/columns.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "core/scene/sweep.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr ColumnName kExponent = "exponent";
constexpr std::int64_t kMaxPoints = 1000;   // along a side
constexpr std::int64_t kMaxCells = 100000;  // of a map
constexpr std::int64_t kFewLines = 10;      // of a stage before many lines
constexpr std::size_t kCoarse = 16;         // points along a side of the first stage

/// Returns at most kCoarse values of a side, with both ends.
MapAxis coarse(const MapAxis& axis) {
  const std::size_t count = axis.values.size();
  if (count <= kCoarse) return axis;
  MapAxis few{axis.range, {}};
  for (std::size_t i = 0; i < kCoarse; ++i)
    few.values.push_back(axis.values[(i * (count - 1) + (kCoarse - 1) / 2) / (kCoarse - 1)]);
  return few;
}

/// Returns the scene with both parameters set.
Scene cellScene(const Scene& scene, const MapAxis& x, double xValue, const MapAxis& y,
                double yValue) {
  Scene cell = scene;
  setNumber(*x.range.row, cell, xValue);
  setNumber(*y.range.row, cell, yValue);
  return cell;
}

/// Computes one stage. lines: 1 for a preview; 0: all lines of the scene.
ParameterMap computeStage(const Scene& scene, const MapAxis& x, const MapAxis& y,
                          std::int64_t lines, const StateOptions& options) {
  ParameterMap map{scene, x, y, {}, 0, lines, false, true};
  std::vector<Scene> states;
  states.reserve(x.values.size() * y.values.size());
  for (const double yValue : y.values)
    for (const double xValue : x.values) {
      states.push_back(cellScene(scene, x, xValue, y, yValue));
      Scene& state = states.back();
      // Titles and comparisons do not influence friction, but would be copied with every scene.
      state.title.clear();
      state.description.clear();
      state.comparison = {};
      if (lines == 0) continue;
      // A preview has the resolution of the final map.
      fixResolution(state);
      state.ensemble.realizations = lines;
    }
  SteadyStates found = slideStates(states, options);
  map.points = std::move(found.points);
  map.computed = found.computed;
  map.isComplete = found.isComplete;
  return map;
}

/// Throws InputError where a map of these sides is impossible.
void checkMap(const Scene& scene, const MapAxis& x, const MapAxis& y) {
  if (x.range.row == y.range.row)
    throw InputError("", std::string(y.key()),
                     "is both sides of the map; they need two different keys");
  const auto cells = static_cast<std::int64_t>(x.values.size() * y.values.size());
  if (cells > kMaxCells)
    throw InputError("", std::string(y.key()),
                     message("{} times {} points are more than {} cells", x.values.size(),
                             y.values.size(), kMaxCells));
  requireNoTarget(scene, "a map has the same lines in every cell");
}

/// Returns the slope at t of the parabola through three points.
double parabolaSlope(const std::array<double, 3>& x, const std::array<double, 3>& y, double t) {
  const double first = (y[1] - y[0]) / (x[1] - x[0]);
  const double second = (y[2] - y[1]) / (x[2] - x[1]);
  const double curvature = (second - first) / (x[2] - x[0]);
  return first + curvature * (2 * t - x[0] - x[1]);
}

/// Returns d ln mu / d ln x along one row; NaN where a logarithm does not exist.
std::vector<double> exponents(const std::vector<double>& x, std::vector<double> mu) {
  std::vector<double> logarithms;
  for (const double value : x) logarithms.push_back(value > 0 ? std::log(value) : kNotApplicable);
  for (double& value : mu) value = std::isgreater(value, 0.0) ? std::log(value) : kNotApplicable;
  std::vector<double> slopes(x.size(), kNotApplicable);
  const auto isKnown = [&](std::size_t i) {
    return !std::isnan(logarithms[i]) && !std::isnan(mu[i]);
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!isKnown(i)) continue;
    if (x.size() == 2) {
      if (isKnown(0) && isKnown(1)) slopes[i] = (mu[1] - mu[0]) / (logarithms[1] - logarithms[0]);
      continue;
    }
    const std::size_t first = std::clamp<std::size_t>(i, 1, x.size() - 2) - 1;
    if (isKnown(first) && isKnown(first + 1) && isKnown(first + 2))
      slopes[i] = parabolaSlope({logarithms[first], logarithms[first + 1], logarithms[first + 2]},
                                {mu[first], mu[first + 1], mu[first + 2]}, logarithms[i]);
  }
  return slopes;
}

/// Returns the names of the first two columns.
std::array<std::string, 2> keyColumns(const ParameterMap& map) {
  std::array names{std::string(columnOfKey(map.x.key())), std::string(columnOfKey(map.y.key()))};
  if (names[0] == names[1]) names = {std::string(map.x.key()), std::string(map.y.key())};
  return names;
}

Json axisJson(const MapAxis& axis) {
  return {{"key", axis.key()},
          {"from", axis.values.front()},
          {"to", axis.values.back()},
          {"points", axis.values.size()},
          {"scale", axis.range.isLogarithmic ? "log" : "linear"}};
}

}  // namespace

bool isMapParameter(const Parameter& row, const Scene& scene) {
  return allowedRange(row) && whyNotSwept(row, scene).empty();
}

MapAxis mapAxis(const Scene& scene, const ParameterRange& range, const ParameterRange* other) {
  const std::string key(range.key());
  const Message reason =
      other ? whyNotBeside(*range.row, scene, *other) : whyNotSwept(*range.row, scene);
  if (!reason.empty()) throw InputError("", "", reason);
  checkRange(range, scene);
  if (range.points < 2 || range.points > kMaxPoints)
    throw InputError(
        "", key,
        message("a map has 2 to {} points along each side, not {}", kMaxPoints, range.points));
  MapAxis axis{range, rangeValues(range)};
  if (axis.values.size() < 2 || axis.values.front() == axis.values.back())
    throw InputError("", key,
                     message("{} to {} is only one value; a side of a map needs two",
                             plain(range.from), plain(range.to)));
  return axis;
}

ParameterRange usualMapRange(const Scene& scene, const Parameter& row, std::int64_t points) {
  const AllowedRange allowed = *allowedRange(row);
  const double now = parameterNumber(row, scene);
  const SliderRange slider = *sliderRange(row);
  ParameterRange range{&row, slider.from, slider.to, points,
                       slider.scale != Scale::Linear && now > 0};
  if (row.key == kVelocityKey && now > 0) {
    range.from = scene.sweep.velocityFrom;
    range.to = scene.sweep.velocityTo;
  } else if (range.isLogarithmic) {
    range.from = std::max(range.from, now / kUsualRangeFactor);
    range.to = std::min(range.to, now * kUsualRangeFactor);
  }
  if (range.isLogarithmic && !(range.from < range.to)) {  // the value lies beyond its slider
    range.from = now / kUsualRangeFactor;
    range.to = now * kUsualRangeFactor;
  }
  range.from = std::max(std::min(range.from, now), allowed.minimum);
  range.to = std::min(std::max(range.to, now), allowed.maximum);
  return range;
}

ParameterMap mapStage(MapStage stage, const Scene& scene, const MapAxis& x, const MapAxis& y,
                      const StateOptions& options) {
  checkMap(scene, x, y);
  const bool isCoarse = stage == MapStage::Coarse;
  const std::int64_t all = scene.ensemble.realizations;  // 0: every row of a measured surface
  std::int64_t lines = 1;
  if (stage == MapStage::FewLines) lines = all == 0 ? kFewLines : std::min(kFewLines, all);
  return computeStage(scene, isCoarse ? coarse(x) : x, isCoarse ? coarse(y) : y, lines, options);
}

ParameterMap parameterMap(const Scene& scene, const MapAxis& x, const MapAxis& y,
                          const StateOptions& options, const MapPreview& preview) {
  checkMap(scene, x, y);
  const bool hasManyLines = mayHaveManyLines(scene.surface) && scene.ensemble.realizations != 1;
  const auto show = [&](const MapAxis& alongX, const MapAxis& alongY, std::int64_t lines) {
    if (!preview || options.stop.stop_requested()) return;
    StateOptions quiet = options;
    quiet.progress = {};
    ParameterMap stage = computeStage(scene, alongX, alongY, lines, quiet);
    if (stage.isComplete) preview(std::move(stage));
  };
  const MapAxis fewX = coarse(x), fewY = coarse(y);
  const bool isLarge = fewX.values.size() < x.values.size() || fewY.values.size() < y.values.size();
  if (isLarge) show(fewX, fewY, 1);
  if (hasManyLines) show(x, y, 1);
  // Every row of a measured surface (0) is usually hundreds.
  const std::int64_t all = scene.ensemble.realizations;
  if (hasManyLines && (all == 0 || all > 2 * kFewLines)) show(x, y, kFewLines);
  ParameterMap map = computeStage(scene, x, y, 0, options);
  map.isFinal = map.isComplete;
  return map;
}

Scene sceneAt(const ParameterMap& map, double x, double y) {
  return cellScene(map.scene, map.x, x, map.y, y);
}

Scene cellScene(const ParameterMap& map, std::size_t i, std::size_t j) {
  return cellScene(map.scene, map.x, map.x.values[i], map.y, map.y.values[j]);
}

bool isWithoutEffect(const ParameterMap& map, bool alongX) {
  const std::size_t columns = map.x.values.size(), rows = map.y.values.size();
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const CurvePoint& first = alongX ? map.at(0, j) : map.at(i, 0);
      const CurvePoint& here = map.at(i, j);
      const auto differs = [](double a, double b) {
        return std::isnan(a) ? !std::isnan(b) : a != b;
      };
      // Along the velocity the column of velocities itself differs, which is no effect.
      if (differs(first.mu, here.mu) || differs(first.muInterface, here.muInterface)) return false;
    }
  return true;
}

bool isMapQuantity(std::string_view name) {
  const std::vector<std::string_view> all = mapQuantities();
  return std::ranges::find(all, name) != all.end();
}

std::vector<std::string_view> mapQuantities() {
  std::vector<std::string_view> names = curveColumns();
  names.push_back(kExponent);
  return names;
}

std::string_view mapQuantityUnit(std::string_view name) {
  for (const Column& column : kColumns)
    if (column.name == name && column.tables.starts_with("curve")) return column.unit;
  return {};
}

std::vector<double> mapValues(const ParameterMap& map, std::string_view quantity) {
  std::vector<double> values;
  values.reserve(map.points.size());
  if (quantity != kExponent) {
    for (const CurvePoint& point : map.points) values.push_back(curveValue(point, quantity));
    return values;
  }
  const std::size_t columns = map.x.values.size();
  for (std::size_t j = 0; j < map.y.values.size(); ++j) {
    std::vector<double> mu;
    for (std::size_t i = 0; i < columns; ++i) mu.push_back(map.at(i, j).mu);
    const std::vector<double> row = exponents(map.x.values, std::move(mu));
    values.insert(values.end(), row.begin(), row.end());
  }
  return values;
}

nlohmann::ordered_json mapProvenance(const ParameterMap& map, std::string_view quantity) {
  Json root = provenance("map", map.scene);
  // Each cell has the resolution of its own curve; one number stands for all where they are equal.
  Json used;
  bool isFirst = true;
  for (std::size_t j = 0; j < map.y.values.size(); ++j)
    for (std::size_t i = 0; i < map.x.values.size(); ++i) {
      const Json points = curvePointsPerElement(cellScene(map, i, j));
      if (isFirst) used = points;
      isFirst = false;
      if (used != points) used = nullptr;
    }
  root["oversampling_used"] = used;
  root["keys"] = {axisJson(map.x), axisJson(map.y)};
  // The options that reproduce the map come first and always in the same order.
  Json options = Json::object();
  for (const auto& [word, axis] : {std::pair{"x", &map.x}, {"y", &map.y}})
    options[word] = fmt::format("{}={}", axis->range.key(), formatRange(axis->range));
  options["show"] = quantity;
  if (Json& given = root["options"]; given.is_object())
    for (const auto& [word, value] : given.items())
      if (!options.contains(word)) options[word] = value;
  root["options"] = std::move(options);
  return root;
}

namespace {

DataTable mapTable(const ParameterMap& map, std::string_view quantity) {
  const auto names = keyColumns(map);
  // What the keys have already is not repeated.
  const CurveTable curve(map.points, {names.begin(), names.end()});
  DataTable table{curve.header({names.begin(), names.end()}), {}};
  const std::size_t columns = map.x.values.size();
  for (std::size_t k = 0; k < map.points.size(); ++k)
    table.rows.push_back(
        curve.row(map.points[k], {map.x.values[k % columns], map.y.values[k / columns]}));
  if (quantity != kExponent) return table;
  table.columns.push_back(kExponent.text());
  const std::vector<double> exponents = mapValues(map, quantity);
  for (std::size_t k = 0; k < exponents.size(); ++k) table.rows[k].emplace_back(exponents[k]);
  return table;
}

}  // namespace

std::string mapCsv(const ParameterMap& map, std::string_view quantity) {
  return tableCsv(mapTable(map, quantity));
}

std::string mapJson(const ParameterMap& map, std::string_view quantity) {
  Json root = mapProvenance(map, quantity);
  root["points"] = tableJson(mapTable(map, quantity));
  return jsonFile(root);
}

}  // namespace asperity
