// Friction curves that are shown together: the present scene's, others to compare with, the
// difference of two settings; on axes with units or dimensionless. The content of a chart as plain
// values, and as a table. Pure; any thread.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/fit/friction_data.h"
#include "core/friction/curve_difference.h"
#include "core/friction/curve_point.h"
#include "core/friction/theories/theory.h"
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

/// A theory beside the present curve, sampled finely over its range of velocities.
struct TheoryCurve {
  Theory theory = Theory::Eq11;
  std::vector<TheoryPoint> points;
};

/// Measured friction, and what the present scene says at each of its points: at the point's own
/// force, pressure and temperature.
struct MeasuredCurve {
  FrictionData data;
  std::vector<CurvePoint> computed;
  /// Velocities on the axis, m/s: where temperatures differ, all are shifted to that of the scene,
  /// v a_T(T) / a_T(T_scene) (Grosch, Proc. R. Soc. A 274, 21 (1963)).
  std::vector<double> velocities;
};

struct CurveSet {
  NamedCurve present;
  std::vector<NamedCurve> pinned;
  std::vector<TheoryCurve> theories;    // those that the scene names, but for Eq. (11)
  std::vector<MeasuredCurve> measured;  // the tables that the scene names
  bool isReduced = false;               // whether measured velocities are shifted
  CurveAxes axes = CurveAxes::Physical;
  std::optional<CurveDifference> difference;  // of the present curve
  // Ranges of the present axes, in their units; equal ends: automatic.
  double xFrom = 0, xTo = 0, yFrom = 0, yTo = 0;
};

/// Returns the palette's colour of a pinned curve; colours of different places differ up to
/// kPinColours.
inline constexpr int kPinColours = 8;
bool showsLaw(const Scene& scene);

int colourOfPin(int place);

/// Returns one row for each point of each curve: the series, all columns of a curve (curve_file.h),
/// and with a comparison its difference in two more columns. Names of series: the scene's title,
/// the differences of a pinned scene, the setting of the comparison, "Eq. (11)".
std::string curveSetCsv(const CurveSet& set);

}  // namespace asperity
