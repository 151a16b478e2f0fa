// Features of curves: straight lines and power laws through points by least squares, the maximum,
// and the borders of regions I to IV of a friction curve (Li et al. 2013, Fig. 2), found on any
// curve by the same rule. Pure; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// y = intercept + slope x.
struct LineFit {
  double intercept = 0, slope = 0;
  double rmsResidual = 0;
};

/// Fits points of equal weight; x and y have one length, with at least two different x. The slope
/// of a plateau, where y changes only in its last digits, is 0.
LineFit fitLine(std::span<const double> x, std::span<const double> y);

/// Fits a power law, ln y = intercept + slope ln x; all values positive.
LineFit fitPower(std::span<const double> x, std::span<const double> y);

/// The velocities at which the curve passes from one region to the next (m/s), by BorderRule; NaN
/// where it never does. Where the maximum lies so high between two points that none of them reaches
/// its neighbourhood, the parabola through the highest points says where the plateau is.
struct RegionBorders {
  double endOfLinear = 0;  // I to II: the curve falls below ofLine of its line through region I
  double toPlateau = 0;    // II to III: it reaches ofMaximum of its maximum
  double offPlateau = 0;   // III to IV: it falls below that again
};

/// The rule that defines the borders; the paper gives none.
struct BorderRule {
  double ofLine = 0.8;      // part of the straight line through region I
  double ofMaximum = 0.95;  // part of the maximum
};

struct CurveMaximum {
  double x = 0;  // m/s of a curve over velocity, else the value of its key
  double value = 0;
};

/// Returns the maximum of the parabola in ln x through the highest value and its neighbours.
CurveMaximum curveMaximum(std::span<const double> x, std::span<const double> values);

/// Returns the borders. velocities: ascending and evenly spaced in their logarithm, values > 0.
/// Region I is the region of the lowest velocity.
RegionBorders regionBorders(std::span<const double> velocities, std::span<const double> values,
                            const BorderRule& rule = {});

/// The names of the regions, by rising velocity.
inline constexpr std::array<const char*, 4> kRegionNames{"I", "II", "III", "IV"};

/// Returns the place of a region among their names, from 0; 4 where it is none of them.
std::size_t regionNumber(std::string_view name);

struct CurveRegion {
  std::string name;         // one of kRegionNames
  double from = 0, to = 0;  // m/s
};

/// Returns the regions that lie within the velocities, in order.
std::vector<CurveRegion> regionsWithin(const RegionBorders& borders, double from, double to);

}  // namespace asperity
