// Friction curves as text: the columns of one table as CSV, the same with scene, version and seed
// as JSON. Numbers in the shortest form that reads back to the same value; what does not apply is
// empty in CSV and null in JSON. Pure functions; equal curves give equal bytes.
#pragma once

#include <string>
#include <vector>

#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

/// Empty where it is not finite.
std::string csvNumber(double value);
/// The names of the columns and the cells of a point, each with its line end.
std::string curveHeader();
std::string curveRow(const CurvePoint& point);

std::string curveCsv(const std::vector<CurvePoint>& points);
std::string curveJson(const std::vector<CurvePoint>& points, const Scene& scene);

}  // namespace asperity
