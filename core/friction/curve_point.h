// The rows of a friction curve: one row, and its computation from averages over realizations at one
// velocity and from columns of the analytical law. Every way to compute a curve uses these. Plain
// values; one thread at a time.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/intervals.h"
#include "core/base/message.h"
#include "core/base/statistics.h"
#include "core/friction/line_mean.h"
#include "core/scene/notes.h"
#include "core/scene/scene.h"

namespace asperity {

class Excitation;
class LineSource;
struct WaveBand;
struct SteadyResult;

/// Not applicable: empty in CSV, null in JSON, not drawn.
inline constexpr double kNotApplicable = kNaN;

/// One row of a friction curve. The columns of its tables are in core/friction/curve_file.cpp.
struct CurvePoint {
  double velocity = 0;                      // m/s
  double mu = 0;                            // mean over realizations
  double muStandardError = kNotApplicable;  // standard error of the mean; needs two realizations
  double muLaw = kNotApplicable;            // Eq. (11)
  double contactFraction = 0;               // L_cont / L
  double rmsSlopeContact = kNotApplicable;  // grad z_cont
  double indentation = 0;                   // m, d above the line's lowest point
  double normalizedMu = kNotApplicable;     // mean of mu / rms slope of the whole line
  double dimensionlessVelocity = kNotApplicable;  // Eq. (13)
  double dimensionlessForce = kNotApplicable;     // Eq. (14)
  std::int64_t realizations = 0;
  /// 95 % confidence interval of mu, including the error of the resolution; only for curves with a
  /// target accuracy.
  double muLow = kNotApplicable, muHigh = kNotApplicable;
  double muInterface = kNotApplicable;  // local friction, in addition to mu, where there is some
  /// Mean tangential over mean normal force, where lines carry different forces: at a constant
  /// indentation. mu is the mean of the lines' own ratios.
  double muRatioOfMeans = kNotApplicable;
  /// For `nodal`: mean over realizations of the part of its load that the element on the edge of
  /// contact bears, where F_N(d) jumps past the force; 1 where it does not jump.
  double marginalShare = kNotApplicable;
  /// Where the scene gives the nominal pressure: the force on one period that it means (N), the
  /// pressure (Pa), and the force over the true area of contact, contact length times width (Pa).
  double normalForce = kNotApplicable, nominalPressure = kNotApplicable,
         meanPressure = kNotApplicable;
  /// 1 where friction rests on frequencies at which the elastomer was not measured, else 0; not
  /// applicable where these are not known (core/friction/excitation.h).
  double extrapolated = kNotApplicable;
  /// Mean number of contact spots in one period; not applicable where nothing was slid, as beside a
  /// law.
  double contactSpots = kNotApplicable;
  /// Whether a table has the column `contact_spots`, and the word `few_contacts` in its notes:
  /// tables of scenes without any key that came with measured surfaces and materials stay as they
  /// are.
  bool listsContacts = false;
  /// The value of the swept key in its unit; not applicable to a curve over velocity.
  double swept = kNotApplicable;
  /// Means over the lines: normal and tangential force on one period (N, of the deformation), the
  /// power that it takes (W), and the normal force over the area in contact (Pa), whose width is
  /// that of the load, or the period where the load has none.
  double forceOnPeriod = kNotApplicable, tangentialForce = kNotApplicable, power = kNotApplicable,
         contactPressure = kNotApplicable;
  NoteSet notes{};  // of the line and the scene; more in core/friction/curve_file.h
};

/// Returns friction as it is measured: of deformation and interface together.
inline double totalMu(const CurvePoint& point) {
  return std::isnan(point.muInterface) ? point.mu : point.mu + point.muInterface;
}

/// Returns the smallest and the largest of several values in words: "0.5 N", "0.5 N to 2 N".
Message extentText(const Extent& values, std::string_view unit);

/// Returns how the nominal pressures of some points become forces on one period, by which width:
/// without a width (m) of the load it is the period, and results depend on it. Nothing where no
/// point has a nominal pressure.
std::optional<Message> pressureNote(std::span<const CurvePoint> points, double width);

/// Returns the same for the scene itself; nothing where its load is no pressure.
std::optional<Message> pressureNote(const Scene& scene);

/// Returns whether so few contact spots bear the load that friction is that of single summits:
/// fewer than kFewContacts in a period that is less than half in contact. Beyond half of it spots
/// are few because they have grown together. With four of them friction scatters by about half its
/// value from line to line, and on the lines of Fig. 2 of Li et al. it begins to leave its plateau,
/// as it does in region IV (core/chart/curve_regions.h).
inline constexpr double kFewContacts = 4;
bool areContactsFew(double contactSpots, double contactFraction);

/// Returns whether tables of the scene's curves have a column `contact_spots`.
bool listsContacts(const Scene& scene);

/// Averages of all columns of a row except for mu's standard error.
struct CurveAverages {
  CurveAverages() = default;
  /// orderedRows: LineSource::orderedRows() of the lines that are added, in their order.
  explicit CurveAverages(std::int64_t orderedRows) : mu(orderedRows) {}

  LineMean mu;
  RunningMean muInterface, contactFraction, rmsSlopeContact, indentation, normalForce,
      tangentialForce, marginalShare, contactSpots;
  RunningMean rmsSlope, normalizedMu;  // of the whole line, and mu over that of the same line

  /// Adds a result. A line without normal force has no coefficient and does not count.
  void add(const SteadyResult& result);
  /// Returns a row with contact, slope and indentation, and mu and its realizations.
  CurvePoint point(double velocity) const;
};

/// The properties of the lines that the columns of a state need; computed once for many states on
/// the same lines.
struct LineProperties {
  double rmsHeight = 0;       // m, of the lines
  double rmsSlope = 0;        // of the lines
  double length = 0;          // m
  bool slopesDiffer = false;  // from line to line
  bool hasRows = false;       // lines are rows of a topography
  NoteSet notes{};            // of the lines
  /// Empty where it is not known at which frequencies the elastomer was measured.
  std::shared_ptr<const std::vector<WaveBand>> waves{};

  /// Returns the properties of the same lines with `factor` times the height.
  LineProperties scaled(double factor) const;
};
LineProperties lineProperties(const LineSource& source, const Elastomer& elastomer);

/// Eqs. (5) to (14) for the lines of a scene. Pure after construction.
class LawColumns {
 public:
  LawColumns(const Scene& scene, const LineSource& source);
  /// Uses lines that several states share; waves may be empty where the elastomer needs none.
  LawColumns(const Scene& scene, const LineProperties& lines);

  /// Adds muLaw, normalizedMu, the dimensionless numbers, the columns of a nominal pressure and the
  /// notes. Removes muInterface where the scene has no local friction, muRatioOfMeans where it
  /// prescribes the force, and marginalShare where the scheme is not nodal. Lines with different
  /// slopes are normalized each by its own.
  void addTo(CurvePoint& point, const CurveAverages& averages) const;

 private:
  double normalized(double mu, const CurveAverages& averages) const;
  void addForces(CurvePoint& point, const CurveAverages& averages) const;

  Scene scene_;
  LineProperties lines_;                          // with the notes on the elastomer as well
  std::shared_ptr<const Excitation> excitation_;  // null where nothing is known to be measured
  bool hasLaw_, hasArms_, hasInterface_;
};

}  // namespace asperity
