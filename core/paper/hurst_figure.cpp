// Fig. 3: six Hurst exponents at a large force, with Eq. (11).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/paper/figure_parts.h"
#include "core/scene/columns.h"

namespace asperity {
namespace {

double hurstOf(const Study& study) {
  return study.scene().surface.hurst;
}

/// Returns a result for each study.
template <class Read>
std::vector<Estimate> estimatesOf(const std::vector<Study>& studies, const Read& read) {
  std::vector<Estimate> estimates;
  for (const Study& study : studies)
    estimates.push_back(jackknife(study.groups(), [&](int out) { return read(study, out); }));
  return estimates;
}

Claim linearClaim(const std::vector<Study>& studies) {
  const auto deviation = [](const Study& study, int out) {
    return std::abs(velocityExponent(study, 0, 0, 4, out) - 1);
  };
  Claim claim{"region_1_is_linear_for_all_H", "p. 2, Fig. 3",
              "At small velocities the coefficient of friction increases linearly with velocity, "
              "for six Hurst exponents",
              "largest |n - 1| of \u03BC \u221D v\u207F over the five lowest velocities"};
  claim.expected = 0;
  claim.criterion = "below 0.02";
  const std::size_t worst = decideByAll(claim, estimatesOf(studies, deviation), below(0.02));
  claim.note = message("Largest at H = {:g}.", hurstOf(studies[worst]));
  return claim;
}

/// Returns the largest |mu / Eq. (11) - 1| up to the maximum.
double lawDeviation(const Study& study, int out) {
  const double top = findPlateau(study, 0).velocity;
  double worst = 0;
  for (std::size_t i = 0; i < study.velocities().size() && study.velocities()[i] <= top; ++i)
    worst = std::max(worst, std::abs(study.mu(0, i, out) / frictionLaw(study.lawInput(0, i)) - 1));
  return worst;
}

/// Returns the largest relative reduction of Eq. (11) by its third term, that of partial contact.
double partOfPartialContact(const Study& study) {
  const double without = std::numeric_limits<double>::infinity();  // beta without such a term
  double largest = 0;
  for (std::size_t i = 0; i < study.velocities().size(); ++i) {
    const LawInput in = study.lawInput(0, i);
    largest = std::max(largest, 1 - frictionLaw(in) / frictionLaw(in, without));
  }
  return largest;
}

Claim lawClaim(const std::vector<Study>& studies) {
  Claim claim{"equation_11", "p. 3, Eq. (11), Fig. 3",
              "Eq. (11) interpolates between regions I, II and III; its quality can be seen in "
              "Fig. 3",
              "largest |\u03BC / Eq. (11) - 1| up to the maximum, \u03B2 as measured"};
  claim.expected = 0;
  claim.criterion = "below 0.25";
  decideByAll(claim, estimatesOf(studies, lawDeviation), below(0.25));
  std::vector<Message> each;
  for (const Study& study : studies)
    each.push_back(
        message("H = {:g}: {:.0f} %", hurstOf(study), 100 * lawDeviation(study, Study::kAll)));
  double partial = 0;
  for (const Study& study : studies) partial = std::max(partial, partOfPartialContact(study));
  claim.note = message(
      "{}. With the rms slope of the whole line for that in contact. The term of partial contact, "
      "with \u03B1 and \u03B2, lowers Eq. (11) by at most {:.2g} % at this force: the figure does "
      "not "
      "test it.",
      listed(each), 100 * partial);
  return claim;
}

/// Returns mu at the highest velocity over the maximum.
double leftAtTheEnd(const Study& study, int out) {
  return study.normalizedMu(0, study.velocities().size() - 1, out) /
         findPlateau(study, 0, out).normalizedMu;
}

Claim outsideClaim(const std::vector<Study>& studies) {
  Claim claim{
      "region_4_out_of_scope", "p. 2, Figs. 3 and 4",
      "At high forces the decreasing region IV is outside the scope of practical velocities",
      "smallest \u03BC at the highest velocity over the maximum"};
  claim.expected = 1;
  claim.criterion = "above 0.9";
  const Study& worst = studies[decideByAll(claim, estimatesOf(studies, leftAtTheEnd), above(0.9))];
  claim.note =
      message("At {:.3g} m/s, smallest at H = {:g}.", worst.velocities().back(), hurstOf(worst));
  return claim;
}

/// Returns a note: where the whole line touches on every realization, only Eq. (8) is tested.
Message noteOnContact(const std::vector<Study>& studies) {
  std::size_t complete = 0, points = 0;
  double part = 0;  // part of the maximum up to which contact is complete
  for (const Study& study : studies) {
    points += study.velocities().size();
    for (std::size_t i = 0; i < study.velocities().size(); ++i) {
      if (study.contactFraction(0, i) < 1 - 1e-12) continue;
      ++complete;
      part = std::max(part, study.normalizedMu(0, i) / findPlateau(study, 0).normalizedMu);
    }
  }
  const double force = dimensionlessForce(studies.front().lawInput(0, 0));
  if (complete == 0) return message("F\u2099/GhL = {:.3g}.", force);
  return message(
      "F\u2099/GhL = {:.3g}: up to {:.0f} % of the maximum, at {} of the {} points, the whole line "
      "is in contact, and the curves are Eq. (8), which has no fitted number.",
      force, 100 * part, complete, points);
}

}  // namespace

void addHurstFigure(Figure& figure, const FigureOptions& options) {
  const std::vector<double> exponents = sixHurstExponents();
  FigureWork work(options, static_cast<double>(exponents.size()));
  std::vector<Study> studies;
  Diagram diagram = frictionDiagram();
  figure.csv = joinedColumns({"hurst"}) + "," + curveHeader();
  for (std::size_t k = 0; k < exponents.size(); ++k) {
    Scene scene = figure.scene;
    scene.surface.hurst = exponents[k];
    const Study& study = studies.emplace_back(
        work.study(scene, {scene.load.normalForce}, sweepVelocities(scene.sweep), 1));
    DiagramSeries law = lawSeries(study, 0, k == 0 ? "Eq. (11)" : "");
    diagram.series.insert(diagram.series.begin() + static_cast<std::ptrdiff_t>(k), law);
    DiagramSeries series = frictionSeries(study, 0, message("H = {:g}", exponents[k]));
    series.mark = SeriesMark::Circle;
    series.stroke = SeriesStroke::None;
    series.colour = static_cast<int>(k);
    diagram.series.push_back(series);
    figure.csv += tableRows(study, 0, fmt::format("{},", exponents[k]));
  }
  figure.sheet.diagrams.push_back(std::move(diagram));
  figure.sheet.note = sentences(
      {noteOnContact(studies),
       "Points: averages with one standard error. Lines: Eq. (11) with the rms slope of the whole "
       "line, \u03B1 = H/(1 + H) and \u03B2 as measured (Fig. 5)."});
  figure.claims = {linearClaim(studies), lawClaim(studies), outsideClaim(studies),
                   fullContactClaim(studies)};
}

}  // namespace asperity
