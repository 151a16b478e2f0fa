#include "core/friction/parameter_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/friction/steady_states.h"
#include "core/scene/columns.h"
#include "core/scene/provenance.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr ColumnName kExponent = "exponent";
constexpr std::size_t kCoarse = 16;  // points along a side of the first stage

bool isNumber(const Parameter& row) {
  return std::holds_alternative<RealField>(row.field) ||
         std::holds_alternative<IntegerField>(row.field);
}

/// Whether steady friction at one velocity may depend on the key; the others say how it is computed
/// and shown.
bool isOfState(std::string_view key) {
  const std::string_view section = key.substr(0, key.find('.'));
  return section == "surface" || section == "elastomer" || section == "load" ||
         section == "interface" || key == "sliding.velocity" || key == "accuracy.oversampling";
}

Scale scaleOf(const Parameter& row) {
  if (const auto* real = std::get_if<RealField>(&row.field)) return real->scale;
  return std::get<IntegerField>(row.field).scale;
}

void setNumber(const Parameter& row, Scene& scene, double value) {
  if (std::holds_alternative<IntegerField>(row.field))
    setValue(row, scene, static_cast<std::int64_t>(std::llround(value)));
  else
    setValue(row, scene, value);
}

double numberOf(const Parameter& row, const Scene& scene) {
  const ParameterValue value = valueOf(row, scene);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return std::get<double>(value);
}

/// At most kCoarse values of a side, with both ends.
MapAxis coarse(const MapAxis& axis) {
  const std::size_t count = axis.values.size();
  if (count <= kCoarse) return axis;
  MapAxis few{axis.key, {}, axis.isLogarithmic};
  for (std::size_t i = 0; i < kCoarse; ++i)
    few.values.push_back(axis.values[(i * (count - 1) + (kCoarse - 1) / 2) / (kCoarse - 1)]);
  return few;
}

/// The scene with both parameters set.
Scene cellScene(const Scene& scene, const MapAxis& x, double xValue, const MapAxis& y,
                double yValue) {
  Scene cell = scene;
  setNumber(x.row(), cell, xValue);
  setNumber(y.row(), cell, yValue);
  return cell;
}

/// Computes one stage. lines: 1 for a preview; 0: all, as the scene says.
ParameterMap stageOf(const Scene& scene, const MapAxis& x, const MapAxis& y, std::int64_t lines,
                     const StateOptions& options) {
  ParameterMap map{scene, x, y, {}, 0, lines, false, true};
  std::vector<Scene> states;
  states.reserve(x.values.size() * y.values.size());
  for (const double yValue : y.values)
    for (const double xValue : x.values) {
      states.push_back(cellScene(scene, x, xValue, y, yValue));
      Scene& state = states.back();
      // Titles and lists beside the curve mean nothing for friction, but are copied with a scene.
      state.title.clear();
      state.description.clear();
      state.comparison = {};
      if (lines == 0) continue;
      // A preview has the resolution of the map that it goes before.
      if (state.accuracy.scheme != Scheme::Nodal)
        state.accuracy.oversampling = pointsPerElementOfCurve(state);
      state.ensemble.realizations = lines;
    }
  SteadyStates found = slideStates(states, options);
  map.points = std::move(found.points);
  map.computed = found.computed;
  map.isComplete = found.isComplete;
  return map;
}

/// The slope at t of the parabola through three points.
double parabolaSlope(const std::array<double, 3>& x, const std::array<double, 3>& y, double t) {
  const double first = (y[1] - y[0]) / (x[1] - x[0]);
  const double second = (y[2] - y[1]) / (x[2] - x[1]);
  const double curvature = (second - first) / (x[2] - x[0]);
  return first + curvature * (2 * t - x[0] - x[1]);
}

/// d ln mu / d ln x along one row; NaN where a logarithm does not exist.
std::vector<double> exponents(const std::vector<double>& x, std::vector<double> mu) {
  std::vector<double> places;
  for (const double value : x) places.push_back(value > 0 ? std::log(value) : kNotApplicable);
  for (double& value : mu) value = std::isgreater(value, 0.0) ? std::log(value) : kNotApplicable;
  std::vector<double> slopes(x.size(), kNotApplicable);
  const auto isKnown = [&](std::size_t i) { return !std::isnan(places[i]) && !std::isnan(mu[i]); };
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!isKnown(i)) continue;
    if (x.size() == 2) {
      if (isKnown(0) && isKnown(1)) slopes[i] = (mu[1] - mu[0]) / (places[1] - places[0]);
      continue;
    }
    const std::size_t first = std::clamp<std::size_t>(i, 1, x.size() - 2) - 1;
    if (isKnown(first) && isKnown(first + 1) && isKnown(first + 2))
      slopes[i] = parabolaSlope({places[first], places[first + 1], places[first + 2]},
                                {mu[first], mu[first + 1], mu[first + 2]}, places[i]);
  }
  return slopes;
}

std::string lastWord(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

/// The names of the two first columns.
std::array<std::string, 2> keyColumns(const ParameterMap& map) {
  std::array<std::string, 2> names{lastWord(map.x.key), lastWord(map.y.key)};
  if (names[0] == names[1]) names = {map.x.key, map.y.key};
  return names;
}

/// The table's own columns, without those that the keys give already.
CurveTable tableOf(const ParameterMap& map) {
  const auto names = keyColumns(map);
  return {map.points, {names.begin(), names.end()}};
}

Json axisJson(const MapAxis& axis) {
  return {{"key", axis.key},
          {"from", axis.values.front()},
          {"to", axis.values.back()},
          {"points", axis.values.size()},
          {"scale", axis.isLogarithmic ? "log" : "linear"}};
}

}  // namespace

const Parameter& mapParameter(const Scene& scene, std::string_view key) {
  const Parameter* row = findParameter(key);
  if (!row) {
    const std::string_view nearest = nearestKey(key);
    throw InputError("", std::string(key),
                     nearest.empty() ? message("unknown key")
                                     : message("unknown key; did you mean {}?", nearest));
  }
  if (!isNumber(*row))
    throw InputError("", std::string(key), "is not a number, which alone can be a side of a map");
  if (!isOfState(key))
    throw InputError("", std::string(key),
                     "says how friction is computed or shown, and cannot be a side of a map");
  if (!isApplicable(*row, scene))
    throw InputError("", std::string(key), "has no meaning in this scene");
  return *row;
}

std::vector<std::string_view> mapKeys(const Scene& scene) {
  std::vector<std::string_view> keys;
  for (const Parameter& row : parameters())
    if (isNumber(row) && isOfState(row.key) && isApplicable(row, scene)) keys.push_back(row.key);
  return keys;
}

MapAxis mapAxis(const Scene& scene, std::string_view key, const MapRange& range) {
  const Parameter& row = mapParameter(scene, key);
  const std::string name(key);
  if (range.points < 2 || range.points > kMostMapPoints)
    throw InputError(
        "", name,
        message("a map has 2 to {} points along each side, not {}", kMostMapPoints, range.points));
  const AllowedRange allowed = *allowedRange(row);
  for (const double end : {range.from, range.to})
    if (!std::isfinite(end) || end < allowed.minimum || end > allowed.maximum)
      throw InputError("", name, message("{} is outside {}", plain(end), allowedText(row)));
  if (range.from == range.to)
    throw InputError("", name, message("the range begins and ends at {}", plain(range.from)));
  MapAxis axis{name, {}, range.isLogarithmic.value_or(scaleOf(row) != Scale::Linear)};
  const bool canBeLogarithmic = range.from > 0 && range.to > 0;
  if (axis.isLogarithmic && !canBeLogarithmic)
    throw InputError("", name,
                     message("a logarithmic range from {} to {} would go through 0; "
                             "FROM:TO:N:linear is a linear one",
                             plain(range.from), plain(range.to)));
  if (axis.isLogarithmic) {
    axis.values = logSpaced(range.from, range.to, range.points);
  } else {
    const auto last = static_cast<double>(range.points - 1);
    for (std::int64_t i = 0; i < range.points; ++i)
      axis.values.push_back(range.from + (range.to - range.from) * static_cast<double>(i) / last);
    axis.values.back() = range.to;
  }
  if (std::holds_alternative<IntegerField>(row.field)) {
    for (double& value : axis.values) value = std::round(value);
    axis.values.erase(std::unique(axis.values.begin(), axis.values.end()), axis.values.end());
    if (axis.values.size() < 2)
      throw InputError("", name,
                       message("a whole number, of which {} to {} has only one", plain(range.from),
                               plain(range.to)));
  }
  return axis;
}

MapRange usualMapRange(const Scene& scene, std::string_view key, std::int64_t points) {
  const Parameter& row = mapParameter(scene, key);
  const AllowedRange allowed = *allowedRange(row);
  double from = 0, to = 0;
  if (const auto* real = std::get_if<RealField>(&row.field)) {
    from = real->sliderFrom;
    to = real->sliderTo;
  } else {
    const auto& whole = std::get<IntegerField>(row.field);
    from = static_cast<double>(whole.sliderFrom);
    to = static_cast<double>(whole.sliderTo);
  }
  const double now = numberOf(row, scene);
  const bool isLogarithmic = scaleOf(row) != Scale::Linear && now > 0;
  if (key == "sliding.velocity") {
    // The curve's own range, which people have chosen for their rubber.
    from = scene.sweep.velocityFrom;
    to = scene.sweep.velocityTo;
    if (now > 0 && (now < from || now > to)) {
      from = std::min(from, now);
      to = std::max(to, now);
    }
  } else if (isLogarithmic) {
    constexpr double kDecades = 100;  // two to each side
    from = std::max(from, now / kDecades);
    to = std::min(to, now * kDecades);
    if (!(from < to)) {  // the value lies beyond its slider
      from = now / kDecades;
      to = now * kDecades;
    }
    from = std::min(from, now);
    to = std::max(to, now);
  } else {
    from = std::min(from, now);
    to = std::max(to, now);
  }
  return {std::max(from, allowed.minimum), std::min(to, allowed.maximum), points, isLogarithmic};
}

ParameterMap parameterMap(const Scene& scene, const MapAxis& x, const MapAxis& y,
                          const MapOptions& options) {
  if (x.key == y.key)
    throw InputError("", y.key, "is both sides of the map; they need two different keys");
  const auto cells = static_cast<std::int64_t>(x.values.size() * y.values.size());
  if (cells > kMostMapCells)
    throw InputError("", y.key,
                     message("{} times {} points are more than {} cells", x.values.size(),
                             y.values.size(), kMostMapCells));
  if (choosesAccuracy(scene))
    throw InputError("", "accuracy.target_relative_error",
                     "a map has the same lines in every cell; give accuracy.scheme and "
                     "ensemble.realizations instead of a target");
  StateOptions work{options.threads, options.stop, {}, false};
  const bool hasManyLines = mayHaveManyLines(scene.surface) && scene.ensemble.realizations != 1;
  const auto show = [&](const MapAxis& alongX, const MapAxis& alongY) {
    if (!options.preview || options.stop.stop_requested()) return;
    ParameterMap stage = stageOf(scene, alongX, alongY, 1, work);
    if (stage.isComplete) options.preview(std::move(stage));
  };
  const MapAxis fewX = coarse(x), fewY = coarse(y);
  const bool isLarge = fewX.values.size() < x.values.size() || fewY.values.size() < y.values.size();
  if (isLarge) show(fewX, fewY);
  if (hasManyLines) show(x, y);
  work.progress = options.progress;
  ParameterMap map = stageOf(scene, x, y, 0, work);
  map.isFinal = map.isComplete;
  return map;
}

Scene sceneOfCell(const ParameterMap& map, std::size_t i, std::size_t j) {
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
      // Along velocities the column of velocities itself differs, which is no effect.
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

std::string_view unitOfMapQuantity(std::string_view name) {
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
  // Each cell has the resolution of its own curve: a number where all have the same.
  Json used;
  bool isFirst = true;
  for (std::size_t j = 0; j < map.y.values.size(); ++j)
    for (std::size_t i = 0; i < map.x.values.size(); ++i) {
      const Json points = pointsPerElementOfCurve(sceneOfCell(map, i, j));
      if (isFirst) used = points;
      isFirst = false;
      if (used != points) used = nullptr;
    }
  root["oversampling_used"] = used;
  root["keys"] = {axisJson(map.x), axisJson(map.y)};
  root["options"] = {{"show", quantity}};
  return root;
}

std::string mapCsv(const ParameterMap& map, std::string_view quantity) {
  const auto names = keyColumns(map);
  const CurveTable table = tableOf(map);
  const bool hasExponent = quantity == kExponent;
  const std::vector<double> exponent =
      hasExponent ? mapValues(map, quantity) : std::vector<double>();
  std::string text = names[0] + "," + names[1] + "," + table.header() +
                     (hasExponent ? "," + kExponent.text() : std::string()) + "\n";
  const std::size_t columns = map.x.values.size();
  for (std::size_t k = 0; k < map.points.size(); ++k) {
    text += fmt::format("{},{},{}", map.x.values[k % columns], map.y.values[k / columns],
                        table.row(map.points[k]));
    if (hasExponent) text += "," + csvNumber(exponent[k]);
    text += '\n';
  }
  return text;
}

std::string mapJson(const ParameterMap& map, std::string_view quantity) {
  const auto names = keyColumns(map);
  const CurveTable table = tableOf(map);
  const bool hasExponent = quantity == kExponent;
  const std::vector<double> exponent =
      hasExponent ? mapValues(map, quantity) : std::vector<double>();
  Json root = mapProvenance(map, quantity);
  Json points = Json::array();
  const std::size_t columns = map.x.values.size();
  for (std::size_t k = 0; k < map.points.size(); ++k) {
    Json row;
    row[names[0]] = map.x.values[k % columns];
    row[names[1]] = map.y.values[k / columns];
    row.update(table.json(map.points[k]));
    if (hasExponent)
      row[kExponent.text()] = std::isfinite(exponent[k]) ? Json(exponent[k]) : Json(nullptr);
    points.push_back(std::move(row));
  }
  root["points"] = std::move(points);
  return root.dump(2) + "\n";
}

}  // namespace asperity
