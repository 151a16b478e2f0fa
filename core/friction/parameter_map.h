// Friction over two parameters of a scene: a table of steady states, one for each pair of values,
// on common random lines. Every cell is the row that `asperity curve` writes for the scene with
// both keys set and the cell's velocity alone: same lines, same scheme, same resolution. A
// resolution that the scene leaves open is therefore chosen for each cell, as its own curve would
// choose it, and not once for the map; it can change by a factor of two somewhere in the map, where
// friction then has a step below half of its standard error (core/scene/resolution.cpp). Work is
// shared as slideStates shares it.
//
// A map may be shown while it is computed: a coarse one of few points on one line comes first, then
// all points on one line, on ten lines where there are far more, and on all of them.
// Threading: a function of its arguments, which uses several threads; same bytes for any number.
// Failure: InputError for a key or range that makes no sense; as slideStates.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/friction/curve_point.h"
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

inline constexpr std::int64_t kMostMapPoints = 1000;  // along a side
inline constexpr std::int64_t kMostMapCells = 100000;

/// Whether the row is a number that friction in this scene depends on (whyNotSwept of
/// core/scene/sweep.h).
bool isMapParameter(const Parameter& row, const Scene& scene);

/// Returns the values of a range. Throws InputError that names the key where it is no such number,
/// or the range has fewer than 2 different values. other: of the other side, at whose ends friction
/// may depend on this parameter though it does not in the scene; may be null.
MapAxis mapAxis(const Scene& scene, const ParameterRange& range,
                const ParameterRange* other = nullptr);

/// Returns a range for a row where none is asked for: that part of its slider around the scene's
/// value that people look at, and for the velocity that of the curve.
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

struct MapOptions {
  int threads = 0;  // 0: as many as the machine has
  std::stop_token stop;
  /// Called with the part of the work that is done, from one thread at a time; may be empty.
  std::function<void(double part)> progress;
  /// Called with each stage before the last one; may be empty, which leaves these stages out.
  std::function<void(ParameterMap stage)> preview;
};

/// Throws InputError where the axes have the same key, or more cells than are allowed, or the scene
/// asks for a target accuracy, which would need another number of lines in each cell.
ParameterMap parameterMap(const Scene& scene, const MapAxis& x, const MapAxis& y,
                          const MapOptions& options = {});

/// Parts of the work: at most 16 x 16 of the cells on one line; all cells on one line; all cells on
/// ten lines, or on those of the scene where they are fewer.
enum class MapStage { Coarse, OneLine, FewLines };

/// Computes such a part, at the resolution of the whole map. Throws as parameterMap.
ParameterMap mapStage(MapStage stage, const Scene& scene, const MapAxis& x, const MapAxis& y,
                      const MapOptions& options = {});

/// The map's scene with other values of its two parameters; whole numbers are rounded. Throws
/// InputError where a value is not allowed.
Scene sceneAt(const ParameterMap& map, double x, double y);

/// The scene of a cell, as one would give it to a curve of one velocity.
Scene cellScene(const ParameterMap& map, std::size_t i, std::size_t j);

/// Whether friction is the same along a side everywhere: its key does nothing here.
bool isWithoutEffect(const ParameterMap& map, bool alongX);

// ---- what a map shows

/// Returns whether a map can show it: a number among the columns of a curve, or `exponent`.
bool isMapQuantity(std::string_view name);
std::vector<std::string_view> mapQuantities();
/// Returns the unit of a quantity; empty for a pure number.
std::string_view mapQuantityUnit(std::string_view name);

/// Returns the quantity in each cell, x fastest; NaN where it does not apply. `exponent` is
/// d ln mu / d ln x, by a parabola in ln x through a cell and its neighbours
/// in x, which are on the same lines; at the ends through the last three.
std::vector<double> mapValues(const ParameterMap& map, std::string_view quantity);

// ---- files

/// Columns: the two keys' last words (whole keys if these are equal), then those of a curve; one
/// row a cell, x fastest; with the quantity `exponent` its column last.
std::string mapCsv(const ParameterMap& map, std::string_view quantity);
std::string mapJson(const ParameterMap& map, std::string_view quantity);
/// Provenance with "keys" and "options".
nlohmann::ordered_json mapProvenance(const ParameterMap& map, std::string_view quantity);

}  // namespace asperity
