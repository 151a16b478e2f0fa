// Common parts of the figures: what is read off curves of averages, the ranges of the paper, means
// that report the progress of the whole figure, series and table rows; and one function for each
// figure, which adds diagram, table and claims to a Figure that has its scene (in its own file:
// velocity_figure.cpp, ...). Only files of this folder use it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "core/chart/diagram.h"
#include "core/friction/curve_features.h"
#include "core/friction/jackknife.h"
#include "core/paper/figure.h"
#include "core/scene/columns.h"
#include "core/scene/data_table.h"

namespace asperity {

/// Returns the exponent n of mu ~ v^n, fitted to velocities `first` to `last` (indices, both
/// included).
double velocityExponent(const GroupedMeans& means, std::size_t j, std::size_t first,
                        std::size_t last, int leftOut = GroupedMeans::kAll);

/// Returns the maximum of mu / rms slope of the line.
CurveMaximum findPlateau(const GroupedMeans& means, std::size_t j,
                         int leftOut = GroupedMeans::kAll);

/// Returns the borders; region I is the region of the lowest velocity.
RegionBorders regionBorders(const GroupedMeans& means, std::size_t j,
                            int leftOut = GroupedMeans::kAll, const BorderRule& rule = {});

/// Returns mu / rms slope at a velocity between computed ones, by linear interpolation of
/// logarithms.
double normalizedMuAt(const GroupedMeans& means, std::size_t j, double velocity,
                      int leftOut = GroupedMeans::kAll);

/// mu compared with Eq. (8), where the whole line is in contact on every realization.
struct FullContact {
  int points = 0;
  double toResolved = 0;  // largest |mu / Eq. (8) - 1| with the rms slope of the line's segments
  double toSpectral = 0;  // the same with the slope of the spectrum: the resolution of the line
};
FullContact compareFullContact(const GroupedMeans& means);

/// Returns the exponent n of what `read` returns for lines of different rms slopes, ~ slope^n.
double slopeExponent(std::span<const GroupedMeans> allMeans,
                     const std::function<double(const GroupedMeans&)>& read);

inline double hurstExponent(const GroupedMeans& means) {
  return means.scene().surface.hurst;
}

/// Returns the number of elements times a factor, at least 3.
std::int64_t scaledElements(const Scene& scene, double factor);

/// Returns F_N (N) for a dimensionless force: Fbar G h L, Eq. (14).
double forceAt(const Scene& scene, double dimensionlessForce);

/// Returns the velocity (m/s) at which Eq. (13) has this value.
double velocityAt(double dimensionlessVelocity, const Scene& scene, double rmsSlope);

/// Returns the dimensionless velocity at which region I of Eq. (11) meets its plateau; f(Fbar) of
/// Eq. (16).
double meetingVelocity(double dimensionlessForce, double hurst);

/// The dimensionless forces for exponents of zone 1 (partial contact), the same for every figure.
/// alpha depends on this window: curves of ln mu over ln Fbar are not quite straight.
inline constexpr double kZone1From = 1e-3, kZone1To = 0.1;
bool isInZone1(double dimensionlessForce, double to = kZone1To);

/// Return Eq. (5)'s exponent and prefactor in zone 1, from forces at velocity index 0. alpha is the
/// slope of ln mu over ln Fbar up to `to`. beta belongs to alpha = H/(1+H) and is the mean of the
/// logarithm up to kBetaUpTo: it is used in Eq. (11), which must hold until contact is complete.
double fitAlpha(const GroupedMeans& means, int leftOut = GroupedMeans::kAll, double to = kZone1To);
double fitBeta(const GroupedMeans& means, int leftOut = GroupedMeans::kAll);
inline constexpr double kBetaUpTo = 1;

/// Returns thirteen forces that cover the window, and one velocity in the limit of slow sliding.
std::vector<LoadCase> zone1Cases(const Scene& scene, double rmsSlope);

/// Returns forces with nine velocities each around the maximum of its curve.
std::vector<LoadCase> plateauCases(const Scene& scene, double rmsSlope,
                                   const std::vector<double>& normalForces);

/// Return the parameters varied in the paper: 20 forces from 1e-3 to 100 N, 20 spacings from 1e-7
/// to 1e-5 m, six Hurst exponents for curves and eleven for coefficients.
std::vector<double> paperForces();
std::vector<double> paperSpacings();
std::vector<double> sixHurstExponents();
std::vector<double> elevenHurstExponents();

/// Returns whether 0.2 < H < 0.8, the range of the paper's statements, without its ends.
bool isInPaperRange(double hurst);

/// Computes means one after another and reports the finished part of all. Costs are in any common
/// unit.
class FigureWork {
 public:
  FigureWork(const FigureOptions& options, double totalCost);

  GroupedMeans computeMeans(const Scene& scene, const std::vector<double>& normalForces,
                            const std::vector<double>& velocities, double cost);
  /// Returns options for other work whose progress counts as `cost`.
  StateOptions next(double cost);

 private:
  const FigureOptions& options_;
  double total_, done_ = 0;
};

/// Computes means for each Hurst exponent of the scene's lines, under the loads that `cases`
/// returns for a scene and the rms slope of its lines, and passes them to `use` in this order.
void forEachHurst(const Scene& scene, std::span<const double> exponents,
                  const FigureOptions& options,
                  const std::function<std::vector<LoadCase>(const Scene&, double rmsSlope)>& cases,
                  const std::function<void(GroupedMeans means)>& use);

/// Returns mu / rms slope over velocity with one standard error; the other function returns Eq.
/// (11) over the same velocities.
DiagramSeries frictionSeries(const GroupedMeans& means, std::size_t j, Message name);
DiagramSeries lawSeries(const GroupedMeans& means, std::size_t j, Message name);

/// Returns a diagram with the axes of these series, and no series yet.
Diagram frictionDiagram();

/// Returns a table without rows that has these columns before those of a curve.
DataTable curvesTable(std::initializer_list<ColumnName> own);

/// Adds the curve of force j; each row begins with these cells.
void addCurve(DataTable& table, const GroupedMeans& means, std::size_t j,
              const std::vector<TableCell>& own);

/// Returns "H = 0.7, h = 500 nm, ...": the parameters that the figure does not vary.
Message parameterLine(const Scene& scene, const FigureEntry& entry);

/// Returns the claim on Eq. (8) in complete contact, from the means of all scenes.
Claim fullContactClaim(std::span<const GroupedMeans> allMeans);

/// The costs of the next two functions, in the unit of FigureWork: they slide further scenes.
inline constexpr double kRegionClaimsCost = 3, kZoneClaimsCost = 13;

/// Returns the claims on what carries the load in regions III and IV, and on where region IV
/// begins. means: those of Fig. 2.
std::vector<Claim> regionClaims(const GroupedMeans& means, FigureWork& work);

/// Returns the claims on twenty forces: zones 1 and 2, their shift, their scaling, the line in
/// contact. means: at the paper's forces and velocities.
std::vector<Claim> zoneClaims(const GroupedMeans& means, FigureWork& work);

void addContactFigure(Figure& figure, const FigureOptions& options);
void addVelocityFigure(Figure& figure, const FigureOptions& options);
void addHurstFigure(Figure& figure, const FigureOptions& options);
void addForcesFigure(Figure& figure, const FigureOptions& options);
void addExponentsFigure(Figure& figure, const FigureOptions& options);
void addPlateauFigure(Figure& figure, const FigureOptions& options);
void addMasterFigure(Figure& figure, const FigureOptions& options);
void addSpacingFigure(Figure& figure, const FigureOptions& options);

}  // namespace asperity
