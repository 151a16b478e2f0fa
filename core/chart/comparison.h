// The theories and the measured friction that a scene names beside its friction curve, with the
// computed friction at each measured point.
// Threading: functions of their arguments; computing uses several threads. Failure: InputError that
// names the file and the row where a table cannot be read (core/fit/friction_data.h).
#pragma once

#include <vector>

#include "core/chart/curve_set.h"
#include "core/friction/steady_states.h"

namespace asperity {

/// The tables that the scene names, in its order. `known`: the last of them, where they have been
/// read already.
std::vector<FrictionData> readComparisonData(const Scene& scene,
                                             const std::vector<FrictionData>& known = {});

/// Adds the theories, except for Eq. (11), which is part of the curve, and the measured friction to
/// a set whose present curve is that of its scene. The computed values are missing where
/// `options.stop` was requested.
void addComparisons(CurveSet& set, std::vector<FrictionData> data,
                    const StateOptions& options = {});

}  // namespace asperity
