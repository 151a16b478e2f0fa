// Friction over two parameters of a scene: a table of steady states, one for each pair of values,
// on common random lines. Every cell is the row that `asperity curve` writes for the scene with
// both keys set and the cell's velocity alone: same lines, same scheme, same resolution. A
// resolution that the scene leaves open is therefore chosen for each cell, as its own curve would
// choose it, and not once for the map; it can change by a factor of two somewhere in the map, where
// friction then has a step below half of its standard error (core/scene/resolution.cpp). Work is
// shared as in slideStates.
//
// A map may be shown while it is computed: first a coarse map on one line, then all points on one
// line, on ten lines where there are far more, and finally on all lines.
// Threading: a function of its arguments, which uses several threads; the bytes are the same for
// any number of them. Failure: InputError for a key or range that has no meaning; else as
// slideStates.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/friction/curve_point.h"
#include "core/friction/steady_states.h"
#include "core/scene/parameters.h"
#include "core/scene/range.h"
#include "core/scene/scene.h"

namespace asperity {

/// The values of a parameter along one side of a map.
struct MapAxis {
  ParameterRange range;
  std::vector<double> values;  // strictly rising or falling

  std::string_view key() const { return range.key(); }
};

/// Returns whether the row is a number on which friction in this scene depends (whyNotSwept of
/// core/scene/sweep.h).
bool isMapParameter(const Parameter& row, const Scene& scene);

/// Returns the values of a range. Throws InputError that names the key where it is no such number,
/// or where the range has fewer than 2 different values. other: the range of the other side, or
/// null. Friction may depend on this parameter only at the ends of the other range.
MapAxis mapAxis(const Scene& scene, const ParameterRange& range,
                const ParameterRange* other = nullptr);

/// Returns the default range of a row: the part of its slider around the scene's value, and for the
/// velocity the range of the curve.
ParameterRange usualMapRange(const Scene& scene, const Parameter& row, std::int64_t points);

struct ParameterMap {
  Scene scene;  // the state at the crosshair; both keys have its own values
  MapAxis x, y;
  std::vector<CurvePoint> points;  // x fastest
  std::size_t computed = 0;        // different states, after equal ones were found
  std::int64_t lines = 0;          // realizations of this stage; 0: all
  bool isFinal = false;            // all points on all lines
  bool isComplete = true;          // false: stopped, and nothing else is meant

  const CurvePoint& at(std::size_t i, std::size_t j) const {
    return points[j * x.values.size() + i];
  }
};

/// Called with each stage of a map before the last one.
using MapPreview = std::function<void(ParameterMap stage)>;

/// Computes the map. Throws InputError where the axes have the same key, or more cells than are
/// allowed, or the scene has a target accuracy, which would need another number of lines in each
/// cell. options: the progress is that of the last stage. preview: where it is empty, the stages
/// before the last one are left out.
ParameterMap parameterMap(const Scene& scene, const MapAxis& x, const MapAxis& y,
                          const StateOptions& options = {}, const MapPreview& preview = {});

/// The preliminary stages: at most 16 x 16 of the cells on one line; all cells on one line; all
/// cells on ten lines, or on those of the scene where they are fewer.
enum class MapStage { Coarse, OneLine, FewLines };

/// Computes such a stage at the resolution of the whole map. Throws as parameterMap.
ParameterMap mapStage(MapStage stage, const Scene& scene, const MapAxis& x, const MapAxis& y,
                      const StateOptions& options = {});

/// Returns the map's scene with other values of its two parameters; whole numbers are rounded.
/// Throws InputError where a value is not allowed.
Scene sceneAt(const ParameterMap& map, double x, double y);

/// Returns the scene of a cell, as for a curve of one velocity.
Scene cellScene(const ParameterMap& map, std::size_t i, std::size_t j);

/// Returns whether friction is constant along a side everywhere, so that its key has no effect
/// here.
bool isWithoutEffect(const ParameterMap& map, bool alongX);

// ---- What a map shows

/// Returns whether a map can show this quantity: a number among the columns of a curve, or
/// `exponent`.
bool isMapQuantity(std::string_view name);
std::vector<std::string_view> mapQuantities();
/// Returns the unit of a quantity; empty for a pure number.
std::string_view mapQuantityUnit(std::string_view name);

/// Returns the quantity in each cell, x fastest; NaN where it does not apply. `exponent` is
/// d ln mu / d ln x, by a parabola in ln x through a cell and its neighbours
/// in x, which are on the same lines; at the ends through the last three.
std::vector<double> mapValues(const ParameterMap& map, std::string_view quantity);

// ---- Files

/// Returns a table with one row for each cell, x fastest. Its columns are the last words of the two
/// keys (the whole keys if these are equal), then those of a curve; for the quantity `exponent` its
/// column is the last one.
std::string mapCsv(const ParameterMap& map, std::string_view quantity);
std::string mapJson(const ParameterMap& map, std::string_view quantity);
/// Returns the provenance with "keys" and "options".
nlohmann::ordered_json mapProvenance(const ParameterMap& map, std::string_view quantity);

}  // namespace asperity
