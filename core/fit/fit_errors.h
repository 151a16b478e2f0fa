// The errors of a fit at its minimum (see fit.h): the covariance of the coordinates by the errors
// of the points and the scatter of the lines, and the scale of the points' errors where these do
// not hold. Pure; several threads.
#pragma once

#include "core/fit/fit.h"
#include "core/fit/fit_objective.h"

namespace asperity {

FitErrors fitErrors(const Objective& objective, const Minimum& best);

/// Returns the largest error of a coordinate with which a parameter counts as determined: a factor
/// of two, or a quarter of a linear slider.
double largestDeterminedError(const VariedParameter& parameter);

}  // namespace asperity
