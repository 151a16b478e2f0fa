// The paper's separate elements marched in time, for the figure that shows what the smallest scale
// decides: by the paper's own rule, and with finer steps. A march costs thousands of times what a
// steady pass does, so there are few lines and, with fine steps, a short distance.
// Threading: lines and velocities run side by side; the results do not depend on how many threads.
// Failure: StudyStopped where `stop` was requested.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/friction/study.h"
#include "core/scene/scene.h"

namespace asperity {

struct ElementPoint {
  double velocity = 0;      // m/s
  Estimate normalizedMu;    // mu / rms slope, over the lines
  double jumpFraction = 0;  // part of the steps in which no indentation meets the force
};

/// The paper's rule: steps of one spacing for one period, Eqs. (1) to (4).
std::vector<ElementPoint> literalCurve(const Scene& scene, std::span<const double> velocities,
                                       std::int64_t lines, const StudyOptions& options);

struct FineSteps {
  std::int64_t perSpacing = 16;
  std::int64_t spacings = 120;  // slid from the resolved line's steady state
  std::int64_t averaged = 40;   // of them, the last ones
};

/// The same number of elements in steps of a part of a spacing, the rate of the indentation
/// included (TimeMarch). Steady sliding repeats itself with every spacing, so a short distance
/// serves once the start has died away, at the rate 1/tau + v/l for a contact of length l.
std::vector<ElementPoint> fineStepCurve(const Scene& scene, std::span<const double> velocities,
                                        std::int64_t lines, const FineSteps& steps,
                                        const StudyOptions& options);

}  // namespace asperity
