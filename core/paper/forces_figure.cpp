// Fig. 4: twenty normal forces; partial contact (zone 1) and complete contact (zone 2).
#include <fmt/format.h>

#include <cmath>

#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/paper/figure_parts.h"
#include "core/scene/columns.h"

namespace asperity {
namespace {

/// Returns a zone's name beside its lines at low velocity; `aside` is the factor between their
/// velocities.
DiagramLabel zoneLabel(const Study& study, std::size_t j, const char* text, double aside) {
  const double level = 0.005;
  const double velocity = study.velocities()[0] * level / study.normalizedMu(j, 0);
  return {text, velocity * aside, level, velocity, level};
}

Diagram diagramOf(const Study& study) {
  Diagram diagram = frictionDiagram();
  const std::size_t last = study.forces() - 1;
  for (std::size_t j = 0; j <= last; ++j) {
    DiagramSeries series = frictionSeries(study, j, "");
    series.ramp = static_cast<double>(j) / static_cast<double>(last);
    for (DiagramPoint& point : series.points) point.low = point.high = kNotApplicable;
    diagram.series.push_back(std::move(series));
  }
  diagram.ramp =
      DiagramRamp{"normal force", PrintedNumber{printedQuantity(study.normalForce(0), "N")},
                  PrintedNumber{printedQuantity(study.normalForce(last), "N")}};
  // The axis leaves out curves below the data of the lowest velocities.
  diagram.y.from = study.normalizedMu(last / 2, 0);
  diagram.y.to = 3;
  diagram.labels = {zoneLabel(study, 2, "zone 1: partial contact", 0.02),
                    zoneLabel(study, last, "zone 2: complete contact", 30)};
  return diagram;
}

}  // namespace

void addForcesFigure(Figure& figure, const FigureOptions& options) {
  FigureWork work(options, 20 + kZoneClaimsCost);
  const Study study =
      work.study(figure.scene, paperForces(), sweepVelocities(figure.scene.sweep), 20);
  figure.csv = joinedColumns({"normal_force"}) + "," + curveHeader();
  for (std::size_t j = 0; j < study.forces(); ++j)
    figure.csv += tableRows(study, j, fmt::format("{},", study.normalForce(j)));
  figure.sheet.diagrams.push_back(diagramOf(study));
  figure.sheet.note =
      "The third curve from the left is that of Fig. 2. In zone 1 curves shift as F\u2099 to the "
      "power H/(1 + H), in zone 2 as F\u2099.";
  figure.claims = zoneClaims(study, work);
}

}  // namespace asperity
