// Friction curves that are shown together: the present scene's, others to compare with, the
// difference of two settings; on axes with units or dimensionless. The content of a chart as plain
// values, and as a table. Pure; any thread.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/friction/curve_difference.h"
#include "core/friction/curve_point.h"
#include "core/scene/scene.h"

namespace asperity {

enum class CurveAxes {
  Physical,       // v in m/s, mu
  Dimensionless,  // Eq. (13) with the rms slope of the whole line, and mu over that slope
};

/// Factors from a curve's velocities and frictions to the values on the axes; NaN where there are
/// none (with more than one relaxation time there is no dimensionless velocity).
struct AxesFactors {
  double velocity = std::numeric_limits<double>::quiet_NaN();
  double friction = std::numeric_limits<double>::quiet_NaN();
};
AxesFactors factorsOf(std::span<const CurvePoint> points, CurveAxes axes);

struct NamedCurve {
  Message name;  // "G = 20 MPa": the difference from the present curve, which has no name
  Scene scene;
  std::vector<CurvePoint> points;
  int place = 0;  // among the pinned curves; it determines colour and mark
  int id = 1;     // of its series in a diagram; above 0 for pinned curves
};

struct CurveSet {
  NamedCurve present;
  std::vector<NamedCurve> pinned;
  CurveAxes axes = CurveAxes::Physical;
  std::optional<CurveDifference> difference;  // of the present curve
  // Ranges of the present axes, in their units; equal ends: automatic.
  double xFrom = 0, xTo = 0, yFrom = 0, yTo = 0;
};

/// Returns the palette's colour of a pinned curve; colours of different places differ up to
/// kPinColours.
inline constexpr int kPinColours = 8;
int colourOfPin(int place);

/// Returns one row for each point of each curve: the series, all columns of a curve (curve_file.h),
/// and with a comparison its difference in two more columns. Names of series: the scene's title,
/// the differences of a pinned scene, the setting of the comparison, "Eq. (11)".
std::string curveSetCsv(const CurveSet& set);

}  // namespace asperity
