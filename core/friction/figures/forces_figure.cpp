// Fig. 4: twenty normal forces; partial contact (zone 1) and complete contact (zone 2).
#include <fmt/format.h>

#include <cmath>

#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/friction/figures/figure_parts.h"
#include "core/friction/figures/figures_each.h"
#include "core/friction/figures/zone_claims.h"

namespace asperity {
namespace {

/// Where a zone's name stands: on its lines at low velocity, off to the side.
DiagramLabel zoneLabel(const Study& study, std::size_t j, const char* text) {
  const double level = 0.02;
  const double velocity = study.velocities()[0] * level / study.normalizedMu(j, 0);
  return {text, velocity, level};
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
  diagram.ramp = DiagramRamp{"normal force", withUnit(study.normalForce(0), "N"),
                             withUnit(study.normalForce(last), "N")};
  // Curves below the data of the lowest velocities would only stretch the picture.
  diagram.y.from = study.normalizedMu(last / 2, 0);
  diagram.y.to = 3;
  diagram.labels = {zoneLabel(study, 2, "zone 1: partial contact"),
                    zoneLabel(study, last - 1, "zone 2: complete contact")};
  return diagram;
}

}  // namespace

void addForcesFigure(Figure& figure, const FigureOptions& options) {
  FigureWork work(options, 30);
  const Study study =
      work.study(figure.scene, paperForces(), sweepVelocities(figure.scene.sweep), 20);
  figure.csv = "normal_force," + curveHeader();
  for (std::size_t j = 0; j < study.forces(); ++j)
    figure.csv += tableRows(study, j, fmt::format("{},", study.normalForce(j)));
  figure.sheet.diagrams.push_back(diagramOf(study));
  figure.sheet.note =
      "The third curve from the left is that of Fig. 2. Zone 1 shifts with F_N^{H/(1+H)}, zone 2 "
      "with F_N.";
  figure.claims = zoneClaims(study, work);
}

}  // namespace asperity
