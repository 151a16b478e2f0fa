// Fig. 3: six Hurst exponents at a large force, with Eq. (11).

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/friction/ensemble.h"
#include "core/paper/figure_parts.h"

namespace asperity {
namespace {

/// Returns a result for each Hurst exponent.
template <class Read>
std::vector<Estimate> estimateEach(const std::vector<GroupedMeans>& allMeans, const Read& read) {
  std::vector<Estimate> estimates;
  for (const GroupedMeans& means : allMeans)
    estimates.push_back(jackknife(means.groups(), [&](int out) { return read(means, out); }));
  return estimates;
}

Claim linearClaim(const std::vector<GroupedMeans>& allMeans) {
  const auto deviation = [](const GroupedMeans& means, int out) {
    return std::abs(velocityExponent(means, 0, 0, 4, out) - 1);
  };
  Claim claim{"region_1_is_linear_for_all_H", "p. 2, Fig. 3",
              "At small velocities the coefficient of friction increases linearly with velocity, "
              "for six Hurst exponents",
              "largest |n - 1| of \u03BC \u221D v\u207F over the five lowest velocities"};
  claim.expected = 0;
  const std::size_t worst = decideByAll(claim, estimateEach(allMeans, deviation), below(0.02));
  claim.note = message("Largest at H = {:g}.", hurstExponent(allMeans[worst]));
  return claim;
}

/// Returns the largest |mu / Eq. (11) - 1| up to the maximum.
double lawDeviation(const GroupedMeans& means, int out) {
  const double top = findPlateau(means, 0).x;
  double worst = 0;
  for (std::size_t i = 0; i < means.velocities().size() && means.velocities()[i] <= top; ++i)
    worst = std::max(worst, std::abs(means.mu(0, i, out) / frictionLaw(means.lawInput(0, i)) - 1));
  return worst;
}

/// Returns the largest relative reduction of Eq. (11) by its third term, that of partial contact.
double partOfPartialContact(const GroupedMeans& means) {
  const double without = std::numeric_limits<double>::infinity();  // beta without such a term
  double largest = 0;
  for (std::size_t i = 0; i < means.velocities().size(); ++i) {
    const LawInput in = means.lawInput(0, i);
    largest = std::max(largest, 1 - frictionLaw(in) / frictionLaw(in, without));
  }
  return largest;
}

Claim lawClaim(const std::vector<GroupedMeans>& allMeans) {
  Claim claim{"equation_11", "p. 3, Eq. (11), Fig. 3",
              "Eq. (11) interpolates between regions I, II and III; its quality can be seen in "
              "Fig. 3",
              "largest |\u03BC / Eq. (11) - 1| up to the maximum, \u03B2 as measured"};
  claim.expected = 0;
  decideByAll(claim, estimateEach(allMeans, lawDeviation), below(0.25));
  std::vector<Message> each;
  for (const GroupedMeans& means : allMeans)
    each.push_back(message("H = {:g}: {:.0f} %", hurstExponent(means),
                           100 * lawDeviation(means, GroupedMeans::kAll)));
  double partial = 0;
  for (const GroupedMeans& means : allMeans)
    partial = std::max(partial, partOfPartialContact(means));
  claim.note = message(
      "{}. With the rms slope of the whole line for that in contact. The term of partial contact, "
      "with \u03B1 and \u03B2, lowers Eq. (11) by at most {:.2g} % at this force: the figure does "
      "not test it.",
      listed(each), 100 * partial);
  return claim;
}

/// Returns mu at the highest velocity over the maximum.
double leftAtTheEnd(const GroupedMeans& means, int out) {
  return means.normalizedMu(0, means.velocities().size() - 1, out) /
         findPlateau(means, 0, out).value;
}

Claim outsideClaim(const std::vector<GroupedMeans>& allMeans) {
  Claim claim{
      "region_4_out_of_scope", "p. 2, Figs. 3 and 4",
      "At high forces the decreasing region IV is outside the scope of practical velocities",
      "smallest \u03BC at the highest velocity over the maximum"};
  claim.expected = 1;
  const GroupedMeans& worst =
      allMeans[decideByAll(claim, estimateEach(allMeans, leftAtTheEnd), above(0.9))];
  claim.note = message("At {:.3g} m/s, smallest at H = {:g}.", worst.velocities().back(),
                       hurstExponent(worst));
  return claim;
}

/// Returns a note: where the whole line touches on every realization, only Eq. (8) is tested.
Message noteOnContact(const std::vector<GroupedMeans>& allMeans) {
  std::size_t complete = 0, points = 0;
  double part = 0;  // part of the maximum up to which contact is complete
  for (const GroupedMeans& means : allMeans) {
    points += means.velocities().size();
    for (std::size_t i = 0; i < means.velocities().size(); ++i) {
      if (means.contactFraction(0, i) < 1 - 1e-12) continue;
      ++complete;
      part = std::max(part, means.normalizedMu(0, i) / findPlateau(means, 0).value);
    }
  }
  const double force = dimensionlessForce(allMeans.front().lawInput(0, 0));
  if (complete == 0) return message("F\u2099/GhL = {:.3g}.", force);
  return message(
      "F\u2099/GhL = {:.3g}: up to {:.0f} % of the maximum, at {} of the {} points, the whole line "
      "is in contact, and the curves are Eq. (8), which has no fitted number.",
      force, 100 * part, complete, points);
}

}  // namespace

void addHurstFigure(Figure& figure, const FigureOptions& options) {
  std::vector<GroupedMeans> allMeans;
  Diagram diagram = frictionDiagram();
  DataTable table = curvesTable({"hurst"});
  const auto cases = [](const Scene& scene, double) {
    return std::vector{atForce(scene.load.normalForce, sweepVelocities(scene.sweep))};
  };
  forEachHurst(figure.scene, sixHurstExponents(), options, cases, [&](GroupedMeans computed) {
    const std::size_t k = allMeans.size();
    const GroupedMeans& means = allMeans.emplace_back(std::move(computed));
    DiagramSeries law = lawSeries(means, 0, k == 0 ? "Eq. (11)" : "");
    diagram.series.insert(diagram.series.begin() + static_cast<std::ptrdiff_t>(k), law);
    DiagramSeries series = frictionSeries(means, 0, message("H = {:g}", hurstExponent(means)));
    series.mark = SeriesMark::Circle;
    series.stroke = SeriesStroke::None;
    series.colour = static_cast<int>(k);
    diagram.series.push_back(series);
    addCurve(table, means, 0, {hurstExponent(means)});
  });
  figure.csv = tableCsv(table);
  figure.sheet.diagrams.push_back(std::move(diagram));
  figure.sheet.note = sentences(
      {noteOnContact(allMeans),
       "Points: averages with one standard error. Lines: Eq. (11) with the rms slope of the whole "
       "line, \u03B1 = H/(1 + H) and \u03B2 as measured (Fig. 5)."});
  figure.claims = {linearClaim(allMeans), lawClaim(allMeans), outsideClaim(allMeans),
                   fullContactClaim(allMeans)};
}

}  // namespace asperity
