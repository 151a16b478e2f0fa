// A friction curve as a diagram: friction over velocity with Eq. (11) and error bars, and the
// parameters in words. Pure; any thread.
#pragma once

#include <span>
#include <string>

#include "core/friction/curve_point.h"
#include "core/friction/diagram.h"
#include "core/scene/scene.h"

namespace asperity {

/// One line of what a scene sets: "H = 0.7, h = 500 nm, G = 10 MPa, ...".
std::string parametersInWords(const Scene& scene);

DiagramSheet curveSheet(const Scene& scene, std::span<const CurvePoint> points);

}  // namespace asperity
