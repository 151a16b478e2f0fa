// Fig. 6: the plateau (region III) over the normal force for several Hurst exponents.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/paper/figure_parts.h"
#include "core/scene/data_table.h"

namespace asperity {
namespace {

struct Top {
  double force = 0;  // dimensionless
  CurveMaximum plateau;
  Estimate normalizedMu;
  double contactFraction = 0, slopeRatio = 0;  // at the velocity nearest to the maximum
};

struct Tops {
  GroupedMeans means;
  std::vector<Top> tops;  // ordered by force
};

Top findTop(const GroupedMeans& means, std::size_t j) {
  Top top;
  top.force = dimensionlessForce(means.lawInput(j, 0));
  top.plateau = findPlateau(means, j);
  top.normalizedMu =
      jackknife(means.groups(), [&](int out) { return findPlateau(means, j, out).value; });
  const std::vector<double>& velocities = means.velocities(j);
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < velocities.size(); ++i)
    if (means.mu(j, i) > means.mu(j, nearest)) nearest = i;
  top.contactFraction = means.contactFraction(j, nearest);
  top.slopeRatio = means.rmsSlopeContact(j, nearest) / means.line().rmsSlope;
  return top;
}

Diagram plateauDiagram(const std::vector<Tops>& all) {
  Diagram diagram{.x = {"normal force F\u2099", "N"},
                  .y = {"plateau of \u03BC/\u2207z", "", AxisScale::Linear, 0, 1.6}};
  DiagramSeries theory{"\u221A2, Eq. (9)"};
  theory.isTheory = true;
  theory.stroke = SeriesStroke::Dashed;
  const GroupedMeans& first = all.front().means;
  theory.points = {{first.normalForce(0), std::numbers::sqrt2},
                   {first.normalForce(first.forces() - 1), std::numbers::sqrt2}};
  diagram.series.push_back(theory);
  for (std::size_t k = 0; k < all.size(); ++k) {
    DiagramSeries series{message("H = {:g}", hurstExponent(all[k].means)), SeriesMark::Circle};
    series.colour = static_cast<int>(k);
    for (std::size_t j = 0; j < all[k].tops.size(); ++j) {
      const auto [value, error] = all[k].tops[j].normalizedMu;
      series.points.push_back(pointWithError(all[k].means.normalForce(j), value, error));
    }
    diagram.series.push_back(std::move(series));
  }
  return diagram;
}

/// Returns the claim on middle Hurst exponents at forces that are not too small, with the number
/// most distant from `expected`.
Claim heightClaim(const std::vector<Tops>& all) {
  Claim claim{"plateau_is_sqrt_2", "p. 3, Eq. (9), Fig. 6",
              "For 0.2 < H < 0.8 and not too small forces the plateau is almost constant, about "
              "\u221A2 times the rms slope",
              "plateau of \u03BC / rms slope most distant from \u221A2, F\u2099 / G h L >= 1"};
  claim.expected = std::numbers::sqrt2;
  claim.criterion = "within 10 % of \u221A2";
  std::vector<Estimate> plateaus;
  double lowest = 2, highest = 0;
  for (const Tops& one : all)
    for (const Top& top : one.tops) {
      if (!isInPaperRange(hurstExponent(one.means)) || top.force < 1) continue;
      lowest = std::min(lowest, top.normalizedMu.value);
      highest = std::max(highest, top.normalizedMu.value);
      plateaus.push_back(top.normalizedMu);
    }
  decideByAll(claim, plateaus, within(claim.expected, 0.1 * claim.expected));
  claim.note = message(
      "From {:.3f} to {:.3f}. \u221A2 assumes exponentially distributed slopes; random phases give "
      "Gaussian ones, for which Eq. (10) is 1.253 times the slope in contact, and 1.596 where the "
      "contact is weighted by the slope. Eq. (10)'s second line lacks the square root of the "
      "contact length as a factor.",
      lowest, highest);
  return claim;
}

Claim hurstClaim(const std::vector<Tops>& all) {
  // The force nearest to F_N / G h L = 10 is used, which all of them have.
  std::size_t at = 0;
  const std::vector<Top>& any = all.front().tops;
  for (std::size_t j = 1; j < any.size(); ++j)
    if (std::abs(std::log(any[j].force / 10)) < std::abs(std::log(any[at].force / 10))) at = j;
  const auto byHeight = [at](const Tops& a, const Tops& b) {
    return a.tops[at].normalizedMu.value < b.tops[at].normalizedMu.value;
  };
  const auto [low, high] = std::minmax_element(all.begin(), all.end(), byHeight);
  Claim claim{
      "plateau_depends_weakly_on_H", "p. 3, Fig. 6",
      "On the plateau the coefficient of friction depends only weakly on the Hurst exponent",
      "smallest over largest plateau of the six Hurst exponents, F\u2099 / G h L near 10"};
  claim.expected = 1;
  const auto ratio = [&](int out) {
    return findPlateau(low->means, at, out).value / findPlateau(high->means, at, out).value;
  };
  decide(claim, jackknife(low->means.groups(), ratio), above(0.85));
  claim.note = message("Smallest at H = {:g}, largest at H = {:g}.", hurstExponent(low->means),
                       hurstExponent(high->means));
  return claim;
}

/// Returns the plateau at the smallest force over the largest plateau.
double remainingPlateau(const Tops& one, int out = GroupedMeans::kAll) {
  double top = 0;
  for (std::size_t j = 0; j < one.means.forces(); ++j)
    top = std::max(top, findPlateau(one.means, j, out).value);
  return findPlateau(one.means, 0, out).value / top;
}

Claim fallClaim(const std::vector<Tops>& all) {
  Claim claim{"plateau_falls_at_small_forces", "p. 4, Fig. 6",
              "The plateau decreases at very small forces",
              "plateau at the smallest force over the largest plateau, mean over H"};
  const auto mean = [&](int out) {
    double sum = 0;
    for (const Tops& one : all) sum += remainingPlateau(one, out);
    return sum / static_cast<double>(all.size());
  };
  decide(claim, jackknife(all.front().means.groups(), mean), below(1));
  std::vector<Message> each;
  for (const Tops& one : all)
    each.push_back(message("H = {:g}: {:.2f}", hurstExponent(one.means), remainingPlateau(one)));
  claim.note = message("{}.", listed(each));
  return claim;
}

/// Returns the claim of p. 4: the dependence is less pronounced for small Hurst exponents and
/// stronger near 1.
Claim strongerClaim(const std::vector<Tops>& all) {
  Claim claim{"fall_grows_with_H", "p. 4, after Eq. (15)",
              "The dependence of the slope in contact on force is less pronounced for H near 0 and "
              "gets stronger for H near 1",
              "what is left of the plateau at the smallest force, for the largest H over that for "
              "the smallest"};
  const auto ratio = [&](int out) {
    return remainingPlateau(all.back(), out) / remainingPlateau(all.front(), out);
  };
  decide(claim, jackknife(all.front().means.groups(), ratio), below(1));
  return claim;
}

}  // namespace

void addPlateauFigure(Figure& figure, const FigureOptions& options) {
  std::vector<Tops> all;
  DataTable table{columnNames({"hurst", "normal_force", "dimensionless_force", "plateau",
                               "plateau_standard_error", "velocity_of_plateau", "contact_fraction",
                               "slope_in_contact_over_slope", "realizations"}),
                  {}};
  const auto cases = [](const Scene& scene, double rmsSlope) {
    return plateauCases(scene, rmsSlope, paperForces());
  };
  forEachHurst(figure.scene, sixHurstExponents(), options, cases, [&](GroupedMeans means) {
    std::vector<Top> tops;
    for (std::size_t j = 0; j < means.forces(); ++j) {
      const Top& top = tops.emplace_back(findTop(means, j));
      table.rows.push_back({hurstExponent(means), means.normalForce(j), top.force,
                            top.normalizedMu.value, top.normalizedMu.standardError, top.plateau.x,
                            top.contactFraction, top.slopeRatio, means.realizations()});
    }
    all.push_back({std::move(means), std::move(tops)});
  });
  figure.csv = tableCsv(table);
  figure.sheet.diagrams = {plateauDiagram(all)};
  figure.sheet.note =
      "The maximum of each averaged curve \u03BC(v), with one standard error. \u221A2 assumes "
      "exponentially distributed slopes; a line of random phases has Gaussian ones.";
  figure.claims = {heightClaim(all), hurstClaim(all), fallClaim(all), strongerClaim(all)};
}

}  // namespace asperity
