// Regions I to IV of a computed friction curve, found from the curve itself by the rule of
// core/friction/curve_features.h where the curve shows them; and the range of velocities in which
// few contacts carry the load, which is region IV. Pure; any thread.
//
// In fast sliding of Kelvin elements every contact is viscous and one-sided, p = 4 eta v |z'|, so
// that F_N / (4 eta v) is the sum of the heights climbed by all contacts of one period. Below about
// a tenth of the rms height h the load rests on the last summits of the period, which are smooth
// below the cut-off: the slope in contact falls, and friction with it (Li et al. 2013, Eq. 15). For
// F_N over four decades friction has then lost 1 to 10 % of its plateau, and 30 % at a hundredth
// of h. The border belongs to the finite period: at given F_N / L and h it moves with L.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/chart/diagram.h"
#include "core/friction/curve_features.h"
#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

/// Returns the regions in order of velocity; those that begin or end beyond the curve end with it.
/// Region I needs a linear beginning, region III a maximum inside the curve or a flat end. There
/// are none for bodies with more than one relaxation time, which the paper's regions do not
/// describe, without friction, and for linearly spaced velocities alone
/// (logVelocitiesBeside in core/friction/ensemble.h).
std::vector<CurveRegion> findRegions(const Scene& scene, std::span<const CurvePoint> points);

/// Returns "linear", "transition", "plateau", "decrease" for "I" to "IV"; empty for others.
std::string_view regionWord(std::string_view name);

/// Returns what happens in the region and how its borders were found, one sentence each.
std::string_view regionSentence(std::string_view name);

struct VelocityRange {
  double from = 0, to = 0;  // m/s
};

/// Few contacts carry the load where F_N / (4 eta v) is below this part of the rms height.
inline constexpr double kFewContactsHeight = 0.1;

/// The sentence for the shade in a diagram.
inline constexpr const char* kFewContactsSentence =
    "Tinted: F\u2099/(4\u03B7v) is below 0.1 h (\u03B7: viscosity). It is the sum of the heights "
    "climbed by all contacts of one period; the border moves with the period L.";

/// Returns F_N / (4 eta v) in m.
double summedContactHeight(double normalForce, double viscosity, double velocity);

/// Returns the velocity (m/s) above which F_N / (4 eta v) is below a tenth of the rms height (m).
/// NaN where this has no meaning: for elastic elements and those with arms, a constant indentation,
/// lines that are not rough.
double fewContactsVelocity(const Scene& scene, double rmsHeight);

/// Returns the same for a computed curve, whose dimensionless columns contain the rms height of its
/// lines.
double fewContactsVelocity(const Scene& scene, std::span<const CurvePoint> points);

/// Returns the part of a velocity range in which few contacts carry the load; nothing where there
/// is none.
std::optional<VelocityRange> fewContactsWithin(double velocity, double first, double last);

/// Returns the same for all velocities of a curve.
std::optional<VelocityRange> fewContactsRange(const Scene& scene,
                                              std::span<const CurvePoint> points);

/// Adds this range as a shade to the diagram, whose x-axis is velocity times `factor`.
void addFewContacts(Diagram& diagram, const std::optional<VelocityRange>& range, double factor = 1);

}  // namespace asperity
