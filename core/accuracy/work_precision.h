// Measured cost of accuracy: every way to compute friction on the scene's own lines, compared with
// a converged reference, in each region of the sweep.
//
// Error: root mean square over lines and a few velocities of (mu - mu_ref) / mu_ref. For `linear`
// and `cubic` it is the error of their resolution; `nodal` and the literal march are other models
// (separate elements), so theirs is a difference. Reference: `cubic` at two high resolutions,
// extrapolated (Richardson); its own error is estimated from their difference.
// Time: processor time of one thread for one simulation (one line, one velocity, balance solved)
// plus the part of making the line that belongs to one velocity of the sweep, because a finer line
// costs both; the median of repeated runs, in which all methods take turns, so that a busy machine
// affects all of them.
// Threading: one thread at a time (time is measured). Failure: InputError for a scene without
// steady sliding or without a region; StopRequested where `stop` was requested.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

enum class Method { Literal, Nodal, Linear, Cubic };

struct MethodChoice {
  Method method = Method::Cubic;
  std::int64_t oversampling = 1;

  bool operator==(const MethodChoice&) const = default;
};

/// Returns "literal march", "nodal", "linear" or "cubic".
std::string_view methodWord(Method method);

/// Returns "cubic x2" or "nodal".
std::string methodName(const MethodChoice& choice);

/// Returns literal, nodal, and linear and cubic with 1, 2, 4, 8 and 16 points per element.
std::vector<MethodChoice> allMethods();

struct WorkPrecisionPoint {
  MethodChoice choice;
  double error = 0;                             // relative, root mean square
  double largest = 0;                           // largest error of any line and velocity
  bool isDifference = false;                    // compared with another model
  double seconds = 0;                           // of one simulation, median
  double lowerQuartile = 0, upperQuartile = 0;  // of the repeated runs
  double lineSeconds = 0;                       // to make and prepare one line
  // of one velocity of the sweep: its simulation and its part of making the line
  double secondsWithLine = 0;
  bool isExtrapolated = false;  // a part of the march was timed; the error is unknown: NaN
  bool isOnFront = false;       // no method of the same model is both faster and more accurate
};

struct RegionPrecision {
  std::string region;                      // "I" ... "IV"
  std::vector<double> velocities;          // m/s
  double referenceError = 0;               // relative, estimated
  std::vector<WorkPrecisionPoint> points;  // in the order of allMethods()
  /// Relative standard error of mu over 1, 2, 4, ... lines, measured from groups of that size.
  std::vector<std::int64_t> lineCounts;
  std::vector<double> standardErrors;
  /// For a march in time on the scene's elements at the middle velocity: relative difference of
  /// friction from half the step, and of its beginning from a longer march. NaN: not measured.
  double timeStepError = kNotApplicable;
  double settlingError = kNotApplicable;

  /// Returns the geometric mean (m/s) of the lowest and the highest velocity.
  double middleVelocity() const { return std::sqrt(velocities.front() * velocities.back()); }
};

struct WorkPrecision {
  Scene scene;
  MethodChoice present;  // of the scene
  std::int64_t lines = 0;
  std::vector<RegionPrecision> regions;
};

struct WorkPrecisionOptions {
  std::int64_t lines = 6;  // maximum number; one where nothing is random
  int repeats = 7;
  std::stop_token stop{};
  std::function<void(double part)> progress{};
};

/// Compares all methods on the scene's lines.
WorkPrecision workPrecision(const Scene& scene, const WorkPrecisionOptions& options = {});

}  // namespace asperity
