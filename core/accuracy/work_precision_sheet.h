// A comparison of methods as tables and as diagrams. Pure; any thread.
#pragma once

#include <string>

#include "core/accuracy/work_precision.h"
#include "core/chart/diagram.h"

namespace asperity {

/// Returns one row for each region and method.
std::string workPrecisionCsv(const WorkPrecision& comparison);

/// Returns the same with scene, version, references and the spread over lines.
std::string workPrecisionJson(const WorkPrecision& comparison);

/// Returns error versus seconds for each region: one curve per method, the front, the scene's
/// present method, and the target where there is one.
DiagramSheet workPrecisionSheet(const WorkPrecision& comparison);

/// Returns standard error versus number of realizations, and versus seconds.
DiagramSheet standardErrorSheet(const WorkPrecision& comparison);

}  // namespace asperity
