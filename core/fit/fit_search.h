// The search for the minimum of a fit (fit.h) from values that may be far away: by logarithms
// first, and from other starts where the minimum that was found is not a good one. Failure:
// InputError for states that cannot slide, StopRequested where the computation was stopped.
#pragma once

#include <Eigen/Core>

#include "core/fit/fit_objective.h"

namespace asperity {

Minimum findMinimum(const Objective& objective, const Eigen::VectorXd& start);

}  // namespace asperity
