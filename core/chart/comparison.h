// The theories and the measured friction that a scene names beside its friction curve, with the
// computed friction at each measured point.
// Threading: functions of their arguments; computing uses several threads. Failure: InputError that
// names the file and the row where a table cannot be read (core/fit/friction_data.h).
#pragma once

#include <string>
#include <vector>

#include "core/chart/curve_set.h"
#include "core/friction/steady_states.h"

namespace asperity {

/// Reads the tables that the scene names, in its order. known: the last ones of them, if they have
/// been read already.
std::vector<FrictionData> readComparisonData(const Scene& scene,
                                             const std::vector<FrictionData>& known = {});

/// Adds tables, named from the present folder, to those that the scene names from its own. Reads
/// each once, so that an error names the file as it was given. Throws InputError (--data) where
/// there are too many.
std::vector<FrictionData> addComparisonData(Scene& scene, const std::vector<std::string>& files);

/// Returns whether there is something to add: another theory than Eq. (11), a table, or an axis on
/// which Eq. (11) is not part of the curve's points.
bool hasComparisons(const CurveSet& set);

/// Places measured points on the horizontal axis of the present scene, and finds whether it is that
/// of the reduced velocity. Throws InputError where its elastomer has no shift at a measured
/// temperature.
void placeMeasured(CurveSet& set);

/// Adds the theories and the measured friction to a set whose present curve is that of its scene;
/// Eq. (11) is part of the curve where the axes are velocity and friction. Over another key than
/// velocity, a table is shown where it has a column of that key (force, nominal pressure,
/// temperature), with the rows whose other values are those of the scene; a note says what is not
/// shown and why. The computed values are missing where `options.stop` was requested.
void addComparisons(CurveSet& set, std::vector<FrictionData> data,
                    const StateOptions& options = {});

}  // namespace asperity
