// The errors of a fit at its minimum (see fit.h): the covariance of the coordinates by the errors
// of the points and the scatter of the lines, and the scale of the points' errors where these do
// not hold. A profile holds one parameter after the other at values about the minimum and fits the
// others again, so that it follows a curved valley.
// Pure; several threads. Failure: InputError for states that cannot slide, StopRequested where the
// computation was stopped.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "core/fit/fit.h"
#include "core/fit/fit_objective.h"

namespace asperity {

FitErrors fitErrors(const Objective& objective, const Minimum& best);

/// Returns the largest error of a coordinate with which a parameter counts as determined: a factor
/// of two, or a quarter of a linear slider.
double largestDeterminedError(const VariedParameter& parameter);

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
