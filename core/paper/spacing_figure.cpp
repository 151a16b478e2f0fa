// The influence of the spacing: the paper's twenty from 1e-7 to 1e-5 m, mu and mu over the rms
// slope.

#include <cmath>

#include "core/friction/curve_features.h"
#include "core/friction/ensemble.h"
#include "core/paper/figure_parts.h"

namespace asperity {
namespace {

Claim lowVelocityClaim(const std::vector<GroupedMeans>& allMeans) {
  Claim claim{"region_1_slope_squared", "p. 2, before Eq. (5)",
              "Simulations with different rms gradients, varied by the spacing, show \u03BC very "
              "accurately proportional to the squared gradient",
              "exponent n of \u03BC \u221D grad\u207F at the lowest velocity, twenty spacings"};
  claim.expected = 2;
  const auto exponent = [&](int out) {
    return slopeExponent(allMeans, [&](const GroupedMeans& means) { return means.mu(0, 0, out); });
  };
  decide(claim, jackknife(allMeans.front().groups(), exponent), within(2, 0.1));
  return claim;
}

Claim maximumClaim(const std::vector<GroupedMeans>& allMeans) {
  Claim claim{"maximum_proportional_to_slope", "p. 2, before Fig. 2",
              "The maximum of the coefficient of friction in the medium range of velocities is "
              "proportional to the rms gradient",
              "exponent n of the maximum \u221D grad\u207F, twenty spacings"};
  claim.expected = 1;
  const auto exponent = [&](int out) {
    return slopeExponent(allMeans, [&](const GroupedMeans& means) {
      return findPlateau(means, 0, out).value * means.line().rmsSlope;
    });
  };
  decide(claim, jackknife(allMeans.front().groups(), exponent), within(1, 0.1));
  return claim;
}

DiagramSeries spacingSeries(const GroupedMeans& means, double ramp, bool isNormalized) {
  DiagramSeries series = frictionSeries(means, 0, "");
  series.ramp = ramp;
  series.dropErrors();
  if (!isNormalized)
    for (DiagramPoint& point : series.points) point.y *= means.line().rmsSlope;
  return series;
}

}  // namespace

void addSpacingFigure(Figure& figure, const FigureOptions& options) {
  const std::vector<double> spacings = paperSpacings();
  double cost = 0;
  for (const double spacing : spacings) cost += 1 / spacing;
  FigureWork work(options, cost);
  Diagram plain = frictionDiagram(), normalized = frictionDiagram();
  plain.title = "coefficient of friction";
  plain.y.title = "friction \u03BC";
  normalized.title = "over the rms slope";
  DataTable table = curvesTable({"spacing", "rms_slope"});
  std::vector<GroupedMeans> allMeans;
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    Scene scene = figure.scene;
    scene.surface.elements = std::llround(scene.surface.length / spacings[k]);
    const GroupedMeans& means = allMeans.emplace_back(work.computeMeans(
        scene, {scene.load.normalForce}, sweepVelocities(scene.sweep), 1 / spacings[k]));
    const double ramp = static_cast<double>(k) / static_cast<double>(spacings.size() - 1);
    plain.series.push_back(spacingSeries(means, ramp, false));
    normalized.series.push_back(spacingSeries(means, ramp, true));
    addCurve(table, means, 0, {spacings[k], means.line().rmsSlope});
  }
  plain.ramp = normalized.ramp =
      DiagramRamp{"spacing", printed(spacings.front(), "m"), printed(spacings.back(), "m")};
  figure.csv = tableCsv(table);
  figure.sheet.diagrams = {std::move(plain), std::move(normalized)};
  figure.sheet.note =
      "The spacing sets the shortest wave of the line and with it the rms slope: it acts as a "
      "parameter of the model.";
  figure.claims = {lowVelocityClaim(allMeans), maximumClaim(allMeans)};
}

}  // namespace asperity
