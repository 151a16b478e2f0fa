// A comparison of methods as tables and as diagrams. Pure; any thread.
#pragma once

#include <string>

#include "core/accuracy/work_precision.h"
#include "core/chart/diagram.h"

namespace asperity {

/// One row for each region and method.
std::string workPrecisionCsv(const WorkPrecision& comparison);

/// The same with scene, version, references and the spread over lines.
std::string workPrecisionJson(const WorkPrecision& comparison);

/// Error against seconds for each region: one line a method, the front, the scene's present choice,
/// and the target where there is one.
DiagramSheet workPrecisionSheet(const WorkPrecision& comparison);

/// Standard error against realizations, and against seconds.
DiagramSheet standardErrorSheet(const WorkPrecision& comparison);

}  // namespace asperity
