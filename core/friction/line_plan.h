// The plan with one of the scene's lines at hand: only then is it known whether contact is complete
// and the search for its edges is left out. Pure function; any thread. Cost: a line and a few
// passes.
#pragma once

#include <vector>

#include "core/scene/plan.h"

namespace asperity {

/// planOf, with the contact search as it is on the first line. Failure: as SteadySolver and
/// LineSource.
std::vector<PlanStage> planOnLine(const Scene& scene, Purpose purpose);

}  // namespace asperity
