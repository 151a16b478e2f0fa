// Common parts of the figures: the ranges of the paper, means that report the progress of the whole
// figure, series and table rows; and one function for each figure, which adds diagram, table and
// claims to a Figure that has its scene (in its own file: velocity_figure.cpp, ...). Only files of
// this folder use it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "core/chart/diagram.h"
#include "core/friction/jackknife.h"
#include "core/paper/figure.h"
#include "core/paper/readings.h"

namespace asperity {

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
  GroupedMeansOptions next(double cost);

 private:
  const FigureOptions& options_;
  double total_, done_ = 0;
};

/// Returns mu / rms slope over velocity with one standard error; the other function returns Eq.
/// (11) over the same velocities.
DiagramSeries frictionSeries(const GroupedMeans& means, std::size_t j, Message name);
DiagramSeries lawSeries(const GroupedMeans& means, std::size_t j, Message name);

DiagramAxis velocityAxis();
DiagramAxis normalizedFrictionAxis();
Diagram frictionDiagram();  // both axes, no series yet

/// Returns the rows of a table for force j; each begins with `lead` ("0.7,").
std::string tableRows(const GroupedMeans& means, std::size_t j, const std::string& lead);

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
