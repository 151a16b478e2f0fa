// What accuracy costs in time, measured: every way to compute friction on the scene's own lines,
// against a converged reference, in each region of the sweep.
//
// Error: root mean square over lines and a few velocities of (mu - mu_ref) / mu_ref. For `linear`
// and `cubic` it is the error of their resolution; `nodal` and the literal march are other models
// (separate elements), so theirs is a difference. Reference: `cubic` at two high resolutions,
// extrapolated (Richardson); its own error is estimated from their difference.
// Time: processor time of one thread for one simulation (one line, one velocity, balance solved)
// and the share that one velocity of the sweep has in making the line, because a finer line costs
// both; the median of repeated runs, all methods by turns, so that a busy machine shifts all.
// Threading: one thread at a time (time is measured). Failure: InputError for a scene without
// steady sliding or without a region; StudyStopped where `stop` was requested.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/friction/study.h"
#include "core/scene/scene.h"

namespace asperity {

enum class Method { Literal, Nodal, Linear, Cubic };

struct MethodChoice {
  Method method = Method::Cubic;
  std::int64_t oversampling = 1;

  bool operator==(const MethodChoice&) const = default;
};

/// "cubic x2", "nodal".
std::string nameOf(const MethodChoice& choice);

/// Literal, nodal, and linear and cubic with 1, 2, 4, 8 and 16 points per element.
std::vector<MethodChoice> allMethods();

struct WorkPrecisionPoint {
  MethodChoice choice;
  double error = 0;                 // relative, root mean square
  double largest = 0;               // of the same, the worst line and velocity
  bool isDifference = false;        // of another model
  double seconds = 0;               // one simulation, median
  double fastest = 0, slowest = 0;  // quartiles of the repeated runs
  double lineSeconds = 0;           // to make one line and prepare it
  double secondsWithLine =
      0;  // of one velocity of the sweep: its simulation, its share of the line
  bool isExtrapolated = false;  // a part of the march was timed; its error is not known: NaN
  bool isOnFront = false;  // nothing known is both faster and more accurate (of the same model)
};

struct RegionPrecision {
  std::string region;                      // "I" ... "IV"
  std::vector<double> velocities;          // m/s
  double referenceError = 0;               // relative, estimated
  std::vector<WorkPrecisionPoint> points;  // in the order of allMethods()
  /// Relative standard error of mu over 1, 2, 4, ... lines, as measured from groups of so many.
  std::vector<std::int64_t> lineCounts;
  std::vector<double> standardErrors;
  /// Of a march in time on the scene's elements at the middle velocity: relative difference of
  /// friction against half the step, and of its beginning against a longer march. NaN: not
  /// measured.
  double timeStepError = kNotApplicable;
  double settlingError = kNotApplicable;
};

struct WorkPrecision {
  Scene scene;
  MethodChoice present;  // of the scene
  std::int64_t lines = 0;
  std::vector<RegionPrecision> regions;
};

struct WorkPrecisionOptions {
  std::int64_t lines = 6;  // at most; one where nothing is random
  int repeats = 7;
  std::stop_token stop;
  std::function<void(double part)> progress;
};

WorkPrecision workPrecision(const Scene& scene, const WorkPrecisionOptions& options = {});

}  // namespace asperity
