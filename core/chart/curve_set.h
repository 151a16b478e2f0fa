// Friction curves that are shown together: the present scene's, others to compare with, the
// difference of two settings; on axes with units or without. What a chart shows, as plain values,
// and the same as a table. Pure; any thread.
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

/// What a curve's velocities and frictions are multiplied by to stand on the axes; NaN where they
/// have no place there (more than one relaxation time has no dimensionless velocity).
struct AxesFactors {
  double velocity = std::numeric_limits<double>::quiet_NaN();
  double friction = std::numeric_limits<double>::quiet_NaN();
};
AxesFactors factorsOf(std::span<const CurvePoint> points, CurveAxes axes);

struct NamedCurve {
  Message name;  // "G = 20 MPa": in what it differs; of the present curve empty
  Scene scene;
  std::vector<CurvePoint> points;
  int place = 0;  // among the pinned: decides colour and mark
  int id = 1;     // of its series in a diagram; of pinned curves above 0
};

struct CurveSet {
  NamedCurve present;
  std::vector<NamedCurve> pinned;
  CurveAxes axes = CurveAxes::Physical;
  std::optional<CurveDifference> difference;  // of the present curve
  // Of the axes as they stand, in their units; equal: as the curves need.
  double xFrom = 0, xTo = 0, yFrom = 0, yTo = 0;
};

/// The palette's colour of a pinned curve; colours of different places differ up to kPinColours.
inline constexpr int kPinColours = 8;
int colourOfPin(int place);

/// One row for each point of each curve: the series, all columns of a curve (curve_file.h), and
/// with a comparison its difference in two more. A series is called what it is: the scene's title,
/// in what a pinned scene differs, the setting that is compared with, "Eq. (11)".
std::string curveSetCsv(const CurveSet& set);

}  // namespace asperity
