// What a scene wants beside its friction curve: theories, and tables of measured friction with the
// computed friction at their points.
// Threading: functions of their arguments; computing uses several threads. Failure: InputError for
// a table that does not read (core/fit/friction_data.h), with the key of the scene that names it.
#pragma once

#include <span>
#include <vector>

#include "core/chart/curve_set.h"
#include "core/friction/steady_states.h"

namespace asperity {

/// The tables that the scene names, in its order.
std::vector<FrictionData> readComparisonData(const Scene& scene);

/// The theories that the scene names, but for Eq. (11), which the curve has itself, over the
/// velocities of its sweep.
std::vector<TheoryCurve> theoryCurves(const Scene& scene);

/// Adds both to a set whose present curve is that of its scene. Where `options.stop` was requested
/// the computed values are missing.
void addComparisons(CurveSet& set, std::vector<FrictionData> data,
                    const StateOptions& options = {});

}  // namespace asperity
