// The theories that are drawn beside a friction curve, each under the name by which a scene and the
// command line choose it. Pure; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/message.h"
#include "core/friction/curve_quantity.h"
#include "core/scene/scene.h"
#include "core/surface/line_source.h"

namespace asperity {

struct TheoryEntry {
  Theory theory;      // its word in scenes and on the command line: theoryWords()
  const char* name;   // in legends
  const char* range;  // one sentence: its range of validity and its source
};
std::span<const TheoryEntry> theoryEntries();
const TheoryEntry& theoryEntry(Theory theory);

struct TheoryPoint {
  double velocity = 0;            // m/s
  double mu = 0;                  // NaN: the theory does not apply
  double contactFraction = 0;     // L_c / L; NaN likewise
  bool isInRange = true;          // where the theory's own assumptions hold
  double swept = kNotApplicable;  // the value of the swept key where it is not the velocity
  /// Of the lines and the load: rms slope, normal force (N) and the area of one period (m^2).
  double rmsSlope = kNotApplicable, normalForce = kNotApplicable, area = kNotApplicable;

  /// Returns the quantity by the theory; NaN where the theory does not give it.
  double value(CurveQuantity quantity) const;
};

/// Returns the theory for a scene at these velocities (m/s). NaN where it does not apply: Eq. (11)
/// without one relaxation time or for a line that is not self-affine; the foundation at low
/// velocity without an equilibrium modulus; all of them at a given indentation, which determines no
/// force. The half-space uses a nominal pressure directly, the others the force that follows from
/// it. Without a nominal pressure the half-space has the force over the square of the period.
std::vector<TheoryPoint> theoryCurve(Theory theory, const Scene& scene, const LineSource& source,
                                     std::span<const double> velocities);

/// Returns the theory over the scene's axis, at `points` values or at those of the sweep where they
/// are more. Over another key than velocity, each value is a state of its own with its line's
/// spectrum. It ends early where `stop` is requested.
std::vector<TheoryPoint> theoryOverAxis(Theory theory, const Scene& scene, std::int64_t points,
                                        const std::stop_token& stop = {});

}  // namespace asperity
