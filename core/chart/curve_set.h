// Friction curves that are shown together: the present scene's, others to compare with, the
// difference of two settings; on axes with units or dimensionless. The content of a chart as plain
// values, and as a table; and what the scene names to be shown beside its curve: theories and
// measured friction. Any thread; pure but for reading tables.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/statistics.h"
#include "core/chart/diagram.h"
#include "core/fit/friction_data.h"
#include "core/friction/curve_difference.h"
#include "core/friction/curve_point.h"
#include "core/friction/curve_quantity.h"
#include "core/friction/steady_states.h"
#include "core/friction/theory_curve.h"
#include "core/scene/scene.h"

namespace asperity {

enum class CurveAxes {
  Physical,       // v in m/s, mu
  Dimensionless,  // Eq. (13) with the rms slope of the whole line, and mu over that slope
};

/// Factors from a curve's velocities and frictions to the values on the axes; NaN where there are
/// none (with more than one relaxation time there is no dimensionless velocity).
struct AxesFactors {
  double velocity = kNaN;
  double friction = kNaN;
};
AxesFactors axesFactors(std::span<const CurvePoint> points, CurveAxes axes);

struct NamedCurve {
  Message name;  // "G = 20 MPa": the difference from the present curve, which has no name
  Scene scene;
  std::vector<CurvePoint> points;
  int index = 0;              // among the pinned curves, from 0; it determines colour and mark
  int id = 1;                 // of its series in a diagram; above 0 for pinned curves
  double familyValue = kNaN;  // of CurveSet::familyKey; NaN: not of the family
};

/// A theory beside the present curve, sampled finely over the axis.
struct TheoryCurve {
  Theory theory = Theory::Eq11;
  std::vector<TheoryPoint> points;
};

/// Measured friction, and that of the present scene at each of its points: at the point's own
/// force, pressure and temperature.
struct MeasuredCurve {
  FrictionData data;
  std::vector<CurvePoint> computed;
  /// Positions of the points on the horizontal axis. Velocities (m/s) are shifted to the scene's
  /// temperature, v a_T(T) / a_T(T_scene), where temperatures differ (Grosch, Proc. R. Soc. A 274,
  /// 21 (1963)), as are those of curves: reduction(). Over another key they are the table's own
  /// values of it.
  std::vector<double> abscissas;

  /// Returns the friction computed at a point, local friction included.
  double computedMu(std::size_t point) const {
    return point < computed.size() ? totalMu(computed[point]) : kNotApplicable;
  }
};

struct CurveSet {
  NamedCurve present;
  std::vector<NamedCurve> pinned;
  /// Those that the scene names. Eq. (11) is among them over another key than velocity and for
  /// other quantities than friction; else the points of the curve have it.
  std::vector<TheoryCurve> theories;
  std::vector<MeasuredCurve> measured;  // the tables that the scene names
  /// Whether the axis is that of the reduced velocity at the temperature of the present scene,
  /// because a table was measured at another one. Every curve is then shifted by its own a_T.
  bool isReduced = false;
  std::vector<Message> notes;  // on the measured friction
  CurveAxes axes = CurveAxes::Physical;
  CurveQuantity y = CurveQuantity::Mu;        // of physical axes
  std::optional<AxisScale> xScale, yScale;    // none: as the sweep's values are spaced; logarithmic
  std::string familyKey;                      // the key in which the pinned curves differ; or empty
  bool isLawNamed = false;                    // whether Eq. (11) was named beside a family
  std::optional<CurveDifference> difference;  // of the present curve
  // Ranges of the present axes, in their units; equal ends: automatic.
  double xFrom = 0, xTo = 0, yFrom = 0, yTo = 0;

  bool isOfVelocity() const { return present.scene.sweep.isOfVelocity(); }
  /// Returns the quantity on the vertical axis.
  CurveQuantity quantity() const {
    return axes == CurveAxes::Dimensionless ? CurveQuantity::NormalizedMu : y;
  }
  /// Returns whether this is mu or, on dimensionless axes, mu over the rms slope.
  bool isOfMu() const { return axes == CurveAxes::Dimensionless || y == CurveQuantity::Mu; }
  /// Returns whether velocities on the axis are shifted.
  bool hasReducedAxis() const { return isReduced && isOfVelocity() && axes == CurveAxes::Physical; }
  /// Returns whether the points of the curve have Eq. (11) as these axes show it. Beside a family
  /// they are not drawn, so that a law that was named is one of the theories.
  bool hasLawInPoints() const { return isOfVelocity() && isOfMu() && !isLawNamed; }
  AxisScale scaleOfX() const;
  AxisScale scaleOfY() const { return yScale.value_or(AxisScale::Logarithmic); }
};

/// Returns the factor from the friction of a measured point to the vertical axis; NaN where the
/// axis shows no friction. Forces and powers follow from what was computed at the point. `factors`:
/// of the present curve on the set's axes.
double measuredFactor(const MeasuredCurve& measured, std::size_t point, const CurveSet& set,
                      const AxesFactors& factors);

/// Returns the factor from the velocities of a scene's curve to those of the axis: on the axis of
/// the reduced velocity a_T of its elastomer over that at the temperature of the axis, so that
/// curves of one rubber at different temperatures coincide; else 1. NaN where the elastomer has no
/// shift at that temperature.
double reduction(const Scene& scene, const CurveSet& set);

/// Return the position of a point of the scene's curve on the horizontal axis, and its value on the
/// vertical axis.
double abscissa(const CurvePoint& point, const Scene& scene, const CurveSet& set);
double ordinate(const CurvePoint& point, const CurveSet& set);

/// Returns whether friction with local friction is drawn beside that of the deformation: measured
/// friction is of both.
bool showsTotal(const CurveSet& set);

/// Returns whether the chart shows forces, which its table then has, too.
bool showsForces(const CurveSet& set);

/// Returns whether Eq. (11) is drawn beside the curve of a scene.
bool showsLaw(const Scene& scene);

/// Number of pinned curves that have different colours.
inline constexpr int kPinColours = 8;

/// The index in the palette of the colour of the theory of a half-space.
inline constexpr int kColourOfHalfSpace = 7;

/// Return the index in the palette of the colour of a pinned curve, and of a measured table, which
/// keeps its own whatever is pinned. The first two tables have other colours than the theories, the
/// present curve, its marker and the first three pinned curves.
int pinColour(int index);
int measuredColour(int index);

/// Returns one row for each point of each curve: the series, all columns of a curve (curve_file.h),
/// on the axis of the reduced velocity this velocity and the temperature of each point, and with a
/// comparison its difference in two more columns. `velocity` is always that of sliding. Names of
/// series: the scene's title, the differences of a pinned scene, the setting of the comparison,
/// "Eq. (11)".
std::string curveSetCsv(const CurveSet& set);

/// Reads the tables that the scene names, in its order. known: the last ones of them, if they have
/// been read already.
std::vector<FrictionData> readComparisonData(const Scene& scene,
                                             const std::vector<FrictionData>& known = {});

/// Adds tables, named from the present folder, to those that the scene names from its own. Reads
/// each once, so that an error names the file as it was given. Throws InputError (--data) where
/// there are too many.
std::vector<FrictionData> addComparisonData(Scene& scene, const std::vector<std::string>& files);

/// Returns whether there is something to add: another theory than Eq. (11), a table, or an axis on
/// which Eq. (11) is not part of the curve's points.
bool hasComparisons(const CurveSet& set);

/// Places measured points on the horizontal axis of the present scene, and finds whether it is that
/// of the reduced velocity. Throws InputError where its elastomer has no shift at a measured
/// temperature.
void placeMeasured(CurveSet& set);

/// Adds the theories and the measured friction to a set whose present curve is that of its scene;
/// Eq. (11) is part of the curve where the axes are velocity and friction. Over another key than
/// velocity, a table is shown where it has a column of that key (force, nominal pressure,
/// temperature), with the rows whose other values are those of the scene; a note says what is not
/// shown and why. The computed values are missing where `options.stop` was requested.
void addComparisons(CurveSet& set, std::vector<FrictionData> data,
                    const StateOptions& options = {});

}  // namespace asperity
