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

/// What a reader of a point has to know, in words of the column `notes`; empty for most.
/// `unresolved_friction`: of the friction by Eq. (4) more than half is what the elastic pressure
/// does, which gives back what it takes: too few of the paper's elements carry the load, and mu is
/// the error of their sum, with either sign.
std::string notesOf(const CurvePoint& point);

/// With a column of notes where a point has one.
std::string curveCsv(const std::vector<CurvePoint>& points);
std::string curveJson(const std::vector<CurvePoint>& points, const Scene& scene);

}  // namespace asperity
