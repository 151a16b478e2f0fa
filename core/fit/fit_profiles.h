// The profiles of a fit (fit.h): one parameter after the other is held at values about the minimum,
// and the others are fitted again, so that a profile follows a curved valley.
// Failure: InputError for states that cannot slide, StopRequested where the computation was
// stopped.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "core/fit/fit_errors.h"
#include "core/fit/fit_objective.h"

namespace asperity {

using FitProfiles = std::vector<std::vector<Minimum>>;  // of each parameter, by its rising values

FitProfiles fitProfiles(const Objective& objective, const Minimum& best, const FitErrors& errors);

/// Returns the lowest point of the profiles, or the minimum where none is lower.
const Minimum& lowestPoint(const FitProfiles& profiles, const Minimum& best);

/// Returns how far below and above its best value the profiles take a coordinate before the sum of
/// squares has risen by one standard error; 0 without profiles.
std::pair<double, double> profileReach(const FitProfiles& profiles, const FitErrors& errors,
                                       Eigen::Index coordinate, double best);

/// Returns the decrease of the sum of squares that changes the parameters by less than a third of
/// their errors.
double negligibleDecrease(const FitErrors& errors);

}  // namespace asperity
