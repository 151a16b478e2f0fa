// Where few summits carry the load, which is what region IV of a friction curve is.
//
// In fast sliding of Kelvin elements every contact is viscous and one-sided, p = 4 eta v |z'|, so
// that F_N / (4 eta v) is the height which the contacts of one period climb together. Below about
// a tenth of the rms height h the load rests on the last summits of the period, which are smooth
// below the cut-off: the slope in contact falls, and friction with it (Li et al. 2013, Eq. 15). For
// F_N over four decades friction has then lost 1 to 10 % of its plateau, and 30 % at a hundredth
// of h. The border belongs to the finite period: at given F_N / L and h it moves with L.
// Pure; any thread.
#pragma once

#include <span>

#include "core/friction/curve_point.h"
#include "core/friction/diagram.h"
#include "core/scene/scene.h"

namespace asperity {

/// Part of the rms height that counts as few summits.
inline constexpr double kFewSummits = 0.1;

/// F_N / (4 eta v) in m.
double climbedHeight(double normalForce, double viscosity, double velocity);

/// The velocity (m/s) above which F_N / (4 eta v) is below a tenth of the rms height (m). NaN where
/// that says nothing: for elastic elements and those with arms, a constant indentation, lines that
/// are not rough.
double fewSummitsVelocity(const Scene& scene, double rmsHeight);

/// The same for a computed curve, whose dimensionless columns hold the rms height of its lines.
double fewSummitsVelocity(const Scene& scene, std::span<const CurvePoint> points);

/// Tints the diagram from `velocity` to `last`, its largest one, in the units of its axis. Nothing
/// where there is no such range.
void addFewSummits(Diagram& diagram, double velocity, double last);

}  // namespace asperity
