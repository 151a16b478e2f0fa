// A motion as a table: friction, indentation, contact and power in its time steps, on any number of
// lines, and the same as a picture.
// Threading: lines are marched on all threads; equal options give equal bytes for any number of
// them. Failure: InputError for a scene or options that cannot run; std::runtime_error where the
// first steady state has no balance; StopRequested where `stop` was requested.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <stop_token>
#include <string>
#include <vector>

#include "core/chart/diagram.h"
#include "core/run/frame.h"
#include "core/scene/scene.h"

namespace asperity {

struct MotionOptions {
  std::int64_t every = 1;     // steps per row; the last step is always a row
  std::int64_t mostRows = 0;  // maximum for a line: `every` grows to meet it; 0: no limit
  std::int64_t lines = 1;     // realizations 0, 1, ...
  int threads = 0;
  std::stop_token stop{};
  /// Called with the steps of all lines; from one thread at a time. May be empty.
  std::function<void(std::int64_t done, std::int64_t total)> progress{};
};

struct MotionTable {
  std::vector<std::vector<TransientSample>> lines;  // of single steps
  std::vector<TransientSample> mean;  // of all lines, over equal parts of the duration
  /// The samples in a picture: for one line the lowest and highest values of short parts of the
  /// duration, so that it shows the peaks of all steps; for several lines their mean.
  std::vector<TransientSample> drawn;
  std::int64_t every = 1;
  double muError = kNotApplicable;        // stated discretization error: root mean square
  double relativeError = kNotApplicable;  // the same over the root mean square of mu
  double spacing = 0, length = 0;         // m, of the lines
  bool hasInterface = false;
};

/// Marches a scene whose sliding is not steady.
MotionTable marchMotion(const Scene& scene, const MotionOptions& options);

/// A column of numbers; NaN where a value does not apply.
struct MotionValues {
  std::string name;
  std::vector<double> values;  // the rows of one line after those of another
};

/// Returns the columns of the table without the last one, which numbers the lines.
std::vector<MotionValues> motionColumns(const MotionTable& table);

std::string motionCsv(const MotionTable& table);

/// Returns the provenance in an answer and in the first line of a table: how the table was made and
/// its accuracy.
nlohmann::ordered_json motionProvenance(const std::string& verb, const Scene& scene,
                                        const MotionTable& table);
std::string motionJson(const Scene& scene, const MotionTable& table);

/// Returns velocity, friction, indentation and contact over time.
DiagramSheet motionSheet(const Scene& scene, const MotionTable& table);

}  // namespace asperity
