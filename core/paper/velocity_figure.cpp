// Fig. 2: the typical curve, with regions I to IV; three curves where they depend on the
// discretization.
#include <algorithm>
#include <cmath>

#include "core/chart/curve_regions.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/paper/element_curves.h"
#include "core/paper/figure_parts.h"

namespace asperity {
namespace {

constexpr double kFineFrom = 0.1;  // m/s; all three agree below it

struct Curves {
  GroupedMeans resolved;
  std::vector<ElementPoint> literal, fine;
  bool isFineCut;  // it ends where the affordable steps are too few
};

/// Returns this part of a figure's realizations, but at least two and at most `most`.
std::int64_t partOfLines(std::int64_t realizations, std::int64_t part, std::int64_t most) {
  return std::min(realizations, std::clamp<std::int64_t>(realizations / part, 2, most));
}

Curves computeCurves(const Scene& scene, const FigureOptions& options, FigureWork& work) {
  const std::vector<double> velocities = sweepVelocities(scene.sweep);
  std::vector<double> fast;
  for (const double velocity : velocities)
    if (velocity >= kFineFrom) fast.push_back(velocity);
  // A march costs as much as hundreds of steady passes, one in fine steps as much as ten thousand.
  const std::int64_t literalLines = partOfLines(options.realizations, 5, 40);
  const std::int64_t fineLines = partOfLines(options.realizations, 33, 6);
  GroupedMeans resolved = work.computeMeans(scene, {scene.load.normalForce}, velocities, 1);
  std::vector<ElementPoint> literal = literalCurve(scene, velocities, literalLines, work.next(4));
  std::vector<ElementPoint> fine = fineStepCurve(scene, fast, fineLines, {}, work.next(10));
  const bool isCut = fine.size() < fast.size();
  return {std::move(resolved), std::move(literal), std::move(fine), isCut};
}

DiagramSeries elementSeries(const std::vector<ElementPoint>& points, const char* name,
                            SeriesMark mark) {
  const std::size_t lines = points.front().normalizedMu.size();
  DiagramSeries series{.name = lines == 1 ? message("{} (1 line)", Message(name))
                                          : message("{} ({} lines)", Message(name), lines),
                       .mark = mark,
                       .stroke = SeriesStroke::Dotted};
  for (const ElementPoint& point : points) {
    const auto [value, error] = point.estimate();
    series.points.push_back(pointWithError(point.velocity, value, error));
  }
  return series;
}

Diagram velocityDiagram(const Curves& curves) {
  const GroupedMeans& means = curves.resolved;
  Diagram diagram = frictionDiagram();
  diagram.series.push_back(lawSeries(means, 0, "Eq. (11)"));
  diagram.series.push_back(
      elementSeries(curves.literal, "the paper's literal rule", SeriesMark::Square));
  if (!curves.fine.empty())
    diagram.series.push_back(
        elementSeries(curves.fine, "N elements, fine steps", SeriesMark::Triangle));
  DiagramSeries band = frictionSeries(means, 0, "");
  band.isBand = true;
  band.stroke = SeriesStroke::None;
  band.colour = 2;
  diagram.series.push_back(band);
  DiagramSeries resolved =
      frictionSeries(means, 0, message("resolved line ({} lines)", means.realizations()));
  resolved.dropErrors();
  resolved.colour = 2;
  diagram.series.push_back(resolved);

  const std::vector<double>& v = means.velocities();
  for (const CurveRegion& region : regionsWithin(regionBorders(means, 0), v.front(), v.back()))
    diagram.spans.push_back({region.from, region.to, region.name});
  const double few = fewContactsVelocity(means.scene(), means.line().rmsHeight);
  addFewContacts(diagram, fewContactsWithin(few, v.front(), v.back()));
  return diagram;
}

std::string csvOf(const Curves& curves) {
  DataTable table = curvesTable({"curve"});
  addCurve(table, curves.resolved, 0, {"resolved"});
  const LawInput in = curves.resolved.lawInput(0, 0);
  const auto add = [&](const std::vector<ElementPoint>& points, const char* name) {
    for (const ElementPoint& element : points) {
      LawInput at = in;
      at.velocity = element.velocity;
      CurvePoint point;
      point.velocity = element.velocity;
      const auto [value, error] = element.estimate();
      point.normalizedMu = value;
      point.mu = value * in.rmsSlope;
      point.muStandardError = error * in.rmsSlope;
      point.muLaw = frictionLaw(at);
      point.contactFraction = point.indentation = kNotApplicable;
      point.dimensionlessVelocity = dimensionlessVelocity(at);
      point.dimensionlessForce = dimensionlessForce(at);
      point.realizations = static_cast<std::int64_t>(element.normalizedMu.size());
      table.rows.push_back(CurveTable().row(point, {name}));
    }
  };
  add(curves.literal, "literal");
  add(curves.fine, "elements_fine_steps");
  return tableCsv(table);
}

/// Returns the index of the last velocity at or below this one.
std::size_t indexBelow(const std::vector<double>& velocities, double velocity) {
  const auto above = std::upper_bound(velocities.begin(), velocities.end(), velocity * (1 + 1e-9));
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - velocities.begin(), 1) - 1);
}

Claim linearClaim(const GroupedMeans& means) {
  // The range ends two decades inside region I.
  const std::size_t last = std::max<std::size_t>(
      2, indexBelow(means.velocities(), regionBorders(means, 0).endOfLinear / 10));
  Claim claim{"region_1_is_linear", "p. 2, Fig. 2",
              "At first the coefficient of friction increases linearly with velocity (region I)",
              "exponent n of \u03BC \u221D v\u207F"};
  claim.expected = 1;
  claim.criterion = "within 0.02 of 1, at velocities below a tenth of region I's end";
  decide(
      claim,
      jackknife(means.groups(), [&](int out) { return velocityExponent(means, 0, 0, last, out); }),
      within(1, 0.02));
  return claim;
}

/// Another rule for the borders, to show their sensitivity to it.
constexpr BorderRule kStrict{0.9, 0.9};

double transitionWidth(const GroupedMeans& means, int out, const BorderRule& rule = {}) {
  const RegionBorders borders = regionBorders(means, 0, out, rule);
  return std::log10(borders.toPlateau / borders.endOfLinear);
}

double transitionFactor(const GroupedMeans& means, int out, const BorderRule& rule = {}) {
  const RegionBorders borders = regionBorders(means, 0, out, rule);
  return normalizedMuAt(means, 0, borders.toPlateau, out) /
         normalizedMuAt(means, 0, borders.endOfLinear, out);
}

Claim widthClaim(const GroupedMeans& means) {
  Claim claim{"region_2_width", "p. 2, Fig. 2", "Region II covers one decade of velocities",
              "decades from 80 % of the line through region I to 95 % of the maximum"};
  claim.expected = 1;
  claim.criterion = "0.7 to 1.3 decades";
  decide(claim, jackknife(means.groups(), [&](int out) { return transitionWidth(means, out); }),
         within(1, 0.3));
  claim.note = message(
      "The paper does not say where it reads the borders. From 90 % of the line to 90 % of the "
      "maximum it is {:.2f} decades.",
      transitionWidth(means, GroupedMeans::kAll, kStrict));
  return claim;
}

Claim factorClaim(const GroupedMeans& means) {
  Claim claim{"region_2_factor", "p. 2, Fig. 2",
              "The coefficient of friction increases in region II by a factor of two",
              "\u03BC at the end of region II over \u03BC at its start, borders as for its width"};
  claim.expected = 2;
  claim.criterion = "1.5 to 2.5";
  decide(claim, jackknife(means.groups(), [&](int out) { return transitionFactor(means, out); }),
         within(2, 0.5));
  claim.note = message(
      "From 90 % of the line to 90 % of the maximum it is {:.2f}. Region II cannot both begin on "
      "the line of slope 1 and grow by two only within a decade.",
      transitionFactor(means, GroupedMeans::kAll, kStrict));
  return claim;
}

Claim plateauClaim(const GroupedMeans& means) {
  Claim claim{"plateau_height", "p. 3, Eq. (9)",
              "On the plateau (region III) \u03BC is about \u221A2 times the rms slope",
              "largest \u03BC / rms slope of the line"};
  claim.expected = std::sqrt(2.0);
  claim.criterion = "within 10 % of \u221A2";
  decide(claim,
         jackknife(means.groups(), [&](int out) { return findPlateau(means, 0, out).value; }),
         within(claim.expected, 0.1 * claim.expected));
  const CurveMaximum plateau = findPlateau(means, 0);
  claim.note = message("At {:.2g} m/s. Mind the fall already at this small force.", plateau.x);
  return claim;
}

constexpr double kLevel = 0.1;  // |n| below which a curve counts as constant

/// Returns the result of fine steps where the number of elements does not matter.
Message fineStepsNote(const Curves& curves) {
  if (curves.fine.empty())
    return message("Fine steps of the same N elements are not resolved by {} per spacing.",
                   FineSteps{}.most);
  // A decade is longer than the fall in the curve.
  const double end = curves.fine.back().velocity, from = end / std::sqrt(10.0);
  const double exponent = exponentFrom(curves.fine, from).value;
  const Message measured =
      std::isfinite(exponent)
          ? message(
                "Fine steps of the same N elements give n = {:.2f} between {:.2g} and "
                "{:.2g} m/s",
                exponent, from, end)
          : message("Fine steps of the same N elements are resolved up to {:.2g} m/s", end);
  if (!curves.isFineCut) return message("{}.", measured);
  return message(
      "{}; beyond, {} of them per spacing are too few for 1 %, and any fixed number has a floor of "
      "its own.",
      measured, FineSteps{}.most);
}

Claim constantLevelClaim(const Curves& curves) {
  const GroupedMeans& means = curves.resolved;
  const std::size_t last = means.velocities().size() - 1;
  const double from = means.velocities()[last] / 10;
  const std::size_t first = indexBelow(means.velocities(), from);
  Claim claim{
      "region_4_constant_level", "p. 2, Fig. 2; abstract",
      "Friction finally drops to another constant level (region IV)",
      "exponent n of \u03BC \u221D v\u207F over the last decade, by the paper's literal rule"};
  claim.expected = 0;
  claim.criterion = "|n| below 0.1; on a resolved line, too, for a plain yes";
  const Bounds level = within(0, kLevel);
  decide(claim, exponentFrom(curves.literal, from), level);
  const Estimate resolved = jackknife(
      means.groups(), [&](int out) { return velocityExponent(means, 0, first, last, out); });
  const Verdict onLine = verdict(resolved, level);
  if (claim.holds == Verdict::Yes && onLine == Verdict::No) {
    claim.holds = Verdict::OnlyForScheme;
    claim.scheme = "literal (one spacing per step)";
  } else {
    claim.holds = both(claim.holds, onLine);
  }
  claim.note = message(
      "n is {:.2f} on the resolved line, which falls on as 1/\u221Av. The level is one node's own "
      "slope: the line moves one spacing per step, so the last contact is a single node, and more "
      "power goes in than is dissipated. {}",
      resolved.value, fineStepsNote(curves));
  return claim;
}

Claim convergenceClaim(const Curves& curves) {
  const auto worst = std::max_element(
      curves.literal.begin(), curves.literal.end(),
      [](const ElementPoint& a, const ElementPoint& b) { return a.jumpFraction < b.jumpFraction; });
  Claim claim{"no_convergence_problems", "p. 2, after Eq. (4)",
              "The algorithm is not iterative and there are no convergence problems",
              "largest part of the steps in which no indentation meets the normal force"};
  claim.expected = 0;
  claim.criterion = "0 by the literal rule";
  decideExactly(claim, worst->jumpFraction, below(0));
  if (claim.holds == Verdict::No) {
    claim.holds = Verdict::OnlyForScheme;
    claim.scheme = "linear or cubic (a resolved line)";
  }
  claim.note = message(
      "At {:.2g} m/s. F\u2099(d) of separate elements jumps where one enters under viscous "
      "pressure; on a resolved line it is continuous and every balance is met to {:.0e}.",
      worst->velocity, std::max(curves.resolved.largestResidual(), 1e-15));
  return claim;
}

}  // namespace

void addVelocityFigure(Figure& figure, const FigureOptions& options) {
  FigureWork work(options, 15 + kRegionClaimsCost);
  const Curves curves = computeCurves(figure.scene, options, work);
  figure.sheet.diagrams.push_back(velocityDiagram(curves));
  std::vector<Message> notes{
      "Regions by 80 % of the line through region I and 95 % of the maximum. In region IV the "
      "smallest scale decides: the constant level appears only where the line moves one spacing in "
      "each step."};
  if (curves.isFineCut && !curves.fine.empty())
    notes.push_back(message(
        "The curve of fine steps ends at {:.2g} m/s, above which {} steps per spacing are too few "
        "for 1 %.",
        curves.fine.back().velocity, FineSteps{}.most));
  if (!figure.sheet.diagrams.front().shades.empty()) notes.emplace_back(kFewContactsSentence);
  figure.sheet.note = sentences(notes);
  figure.csv = csvOf(curves);
  const GroupedMeans& means = curves.resolved;
  figure.claims = {linearClaim(means),  widthClaim(means),          factorClaim(means),
                   plateauClaim(means), constantLevelClaim(curves), convergenceClaim(curves)};
  for (Claim& claim : regionClaims(means, work)) figure.claims.push_back(std::move(claim));
}

}  // namespace asperity
