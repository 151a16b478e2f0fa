// The paper's separate elements marched in time, for the figure that shows where the smallest scale
// matters: by the paper's own rule, and with finer steps. A march costs hundreds of times as much
// as a steady pass, so there are fewer lines.
// Threading: lines run side by side; the results do not depend on the number of threads.
// Failure: StopRequested where `stop` was requested.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/friction/jackknife.h"
#include "core/scene/scene.h"

namespace asperity {

/// The values mu / rms slope at one velocity, for each line.
struct ElementPoint {
  double velocity = 0;  // m/s
  std::vector<double> normalizedMu{};
  double jumpFraction = 0;           // part of the steps in which no indentation gives the force
  std::int64_t stepsPerSpacing = 1;  // number used

  /// Returns the mean over all lines except for one group; GroupedMeans::kAll: over all.
  double mean(int leftOut = GroupedMeans::kAll) const;
  Estimate estimate() const;
};

/// Returns the exponent n of mu ~ v^n over the points from this velocity (m/s) on; no number with
/// fewer than two of them.
Estimate exponentFrom(std::span<const ElementPoint> points, double velocity);

/// Returns results by the paper's rule: 200 steps of one spacing, Eqs. (1) to (4), of which the
/// last fifth is averaged. A march begins with the steady shape of the same elements if one of them
/// may be partly loaded; its result agrees within 1e-4 with that of many periods from a flat
/// elastomer.
std::vector<ElementPoint> literalCurve(const Scene& scene, std::span<const double> velocities,
                                       std::int64_t lines, const StateOptions& options);

/// The number of steps per spacing: from `first` on, doubled until twice as many change mu by less
/// than `tolerance`, as the mean over the lines of the relative change. Contact at high velocity is
/// far shorter than a spacing, so that any fixed number of steps has a minimum error.
struct FineSteps {
  std::int64_t first = 4, most = 256;  // per spacing
  double tolerance = 0.01;
  std::int64_t spacings = 40;  // slid from the resolved line's steady state
  std::int64_t averaged = 4;   // of them, the last ones
};

/// Returns results of the same elements in steps of a part of a spacing, including the rate of the
/// indentation (TimeMarch). Steady sliding repeats itself with every spacing, so a short distance
/// suffices once the start has decayed, at the rate 1/tau + v/l for a contact of length l.
/// velocities ascending; the curve ends before the first one at which `most` steps are too few.
std::vector<ElementPoint> fineStepCurve(const Scene& scene, std::span<const double> velocities,
                                        std::int64_t lines, const FineSteps& steps,
                                        const StateOptions& options);

}  // namespace asperity
