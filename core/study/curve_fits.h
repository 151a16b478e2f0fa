// Numbers that summarize a whole friction curve, as outputs of a study: its maximum, exponents by
// least squares, and the velocities at which its regions begin. Each is a column of the study's
// table under its own name. Pure; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/friction/curve_point.h"
#include "core/scene/columns.h"
#include "core/scene/scene.h"

namespace asperity {

enum class CurveFit {
  Maximum,
  PlaceOfMaximum,
  HalfWidth,
  Exponent,
  ExponentResidual,
  Plateau,
  BeginOfRegion2,
  BeginOfRegion3,
  BeginOfRegion4,
  ExponentOfRegion1,
  ExponentOfRegion2,
  ExponentOfRegion3,
  ExponentOfRegion4,
};

struct CurveFitEntry {
  ColumnName name;
  bool isOfRegions;  // of a curve over velocity, of one relaxation time (curve_regions.h)
};

/// All of them, in the order of CurveFit.
inline constexpr std::array<CurveFitEntry, 13> kCurveFits{{
    {"fit.maximum", false},
    {"fit.place_of_maximum", false},
    {"fit.half_width", false},
    {"fit.exponent", false},
    {"fit.exponent_residual", false},
    {"fit.plateau", true},
    {"fit.begin_of_region_2", true},
    {"fit.begin_of_region_3", true},
    {"fit.begin_of_region_4", true},
    {"fit.exponent_region_1", true},
    {"fit.exponent_region_2", true},
    {"fit.exponent_region_3", true},
    {"fit.exponent_region_4", true},
}};

/// The minimum number of points of a fit.
inline constexpr std::size_t kMinFitted = 3;

using CurveFitValues = std::array<double, kCurveFits.size()>;

/// Returns all fits of a scene's curve: `points` belong to the values of its sweep, in their order.
/// NaN: the curve has no such number, or too few of its points show it.
CurveFitValues curveFits(const Scene& scene, std::span<const double> values,
                         std::span<const CurvePoint> points);

}  // namespace asperity
