// Fig. 4: twenty normal forces; partial contact (zone 1) and complete contact (zone 2).
#include "core/friction/ensemble.h"
#include "core/paper/figure_parts.h"

namespace asperity {
namespace {

/// Returns a zone's name beside its lines at low velocity; `aside` is the factor between their
/// velocities.
DiagramLabel zoneLabel(const GroupedMeans& means, std::size_t j, const char* text, double aside) {
  const double level = 0.005;
  const double velocity = means.velocities()[0] * level / means.normalizedMu(j, 0);
  return {text, velocity * aside, level, velocity, level};
}

Diagram forcesDiagram(const GroupedMeans& means) {
  Diagram diagram = frictionDiagram();
  const std::size_t last = means.forces() - 1;
  for (std::size_t j = 0; j <= last; ++j) {
    DiagramSeries series = frictionSeries(means, j, "");
    series.ramp = static_cast<double>(j) / static_cast<double>(last);
    series.dropErrors();
    diagram.series.push_back(std::move(series));
  }
  diagram.ramp = DiagramRamp{"normal force", printed(means.normalForce(0), "N"),
                             printed(means.normalForce(last), "N")};
  // The axis leaves out curves below the data of the lowest velocities.
  diagram.y.from = means.normalizedMu(last / 2, 0);
  diagram.y.to = 3;
  diagram.labels = {zoneLabel(means, 2, "zone 1: partial contact", 0.02),
                    zoneLabel(means, last, "zone 2: complete contact", 30)};
  return diagram;
}

}  // namespace

void addForcesFigure(Figure& figure, const FigureOptions& options) {
  FigureWork work(options, 20 + kZoneClaimsCost);
  const GroupedMeans means =
      work.computeMeans(figure.scene, paperForces(), sweepVelocities(figure.scene.sweep), 20);
  DataTable table = curvesTable({"normal_force"});
  for (std::size_t j = 0; j < means.forces(); ++j)
    addCurve(table, means, j, {means.normalForce(j)});
  figure.csv = tableCsv(table);
  figure.sheet.diagrams.push_back(forcesDiagram(means));
  figure.sheet.note =
      "The third curve from the left is that of Fig. 2. In zone 1 curves shift as F\u2099 to the "
      "power H/(1 + H), in zone 2 as F\u2099.";
  figure.claims = zoneClaims(means, work);
}

}  // namespace asperity
