#include "core/paper/figure_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/number_text.h"
#include "core/chart/curve_regions.h"
#include "core/friction/curve_features.h"
#include "core/friction/ensemble.h"
#include "core/material/element_law.h"
#include "core/paper/load_shares.h"

namespace asperity {
namespace {

constexpr std::int64_t kShareLines = 40;  // lines whose shapes are evaluated

/// Velocities over that of the maximum; the last one is the highest velocity of the curve.
constexpr std::array kAround{0.25, 0.5, 1.0, 2.0, 4.0};
constexpr std::size_t kAtMaximum = 2, kAtTheEnd = kAround.size();

LoadShares computeShares(const GroupedMeans& means, FigureWork& work) {
  std::vector<double> velocities;
  for (const double factor : kAround) velocities.push_back(factor * findPlateau(means, 0).x);
  velocities.push_back(means.velocities().back());
  return {means.scene(),
          {atForce(means.normalForce(0), velocities)},
          std::min(means.realizations(), kShareLines),
          work.next(0.2)};
}

/// Returns the part of the springs at the maximum, whose place has the uncertainty of the curve;
/// interpolated linearly in logarithms between the velocities around it.
double elasticAtMaximum(const GroupedMeans& means, const LoadShares& shares, int out) {
  const std::vector<double>& v = shares.loadCase(0).velocities;
  const double velocity =
      std::clamp(findPlateau(means, 0, out).x, v.front(), v[kAround.size() - 1]);
  std::size_t i = 0;
  while (i + 2 < kAround.size() && velocity > v[i + 1]) ++i;
  const double here = shares.elastic(0, i, out), next = shares.elastic(0, i + 1, out);
  return here * std::pow(next / here, std::log(velocity / v[i]) / std::log(v[i + 1] / v[i]));
}

Claim viscousClaim(const GroupedMeans& means, const LoadShares& shares) {
  Claim claim{"elasticity_negligible_on_plateau", "p. 3, after Eq. (9)",
              "In the plateau region the elastomer behaves practically as a viscous fluid: the "
              "elasticity does not play any role",
              "part of the normal force that the springs carry at the maximum of the curve"};
  claim.expected = 0;
  decide(claim,
         jackknife(shares.groups(), [&](int out) { return elasticAtMaximum(means, shares, out); }),
         below(0.1));
  claim.note = message("The trailing sides of the summits carry {:.2g} % of it there.",
                       100 * shares.trailing(0, kAtMaximum));
  return claim;
}

Claim followClaim(const GroupedMeans& means, const LoadShares& shares) {
  Claim claim{
      "region_4_follows_slope", "p. 4, Eqs. (9) and (15)",
      "The decrease at large velocities (region IV) is related to the dependence of the "
      "rms slope on the size of the real contact",
      "\u03BC / slope in contact at the highest velocity over that at the maximum, mean over "
      "the lines of each"};
  const auto ratio = [&](int out) {
    return shares.frictionOverSlope(0, kAtTheEnd, out) /
           shares.frictionOverSlope(0, kAtMaximum, out);
  };
  claim.expected = 1;
  decide(claim, jackknife(shares.groups(), ratio), within(1, 0.1));
  const std::size_t last = means.velocities().size() - 1;
  claim.note = message(
      "Friction itself falls to {:.2g} of its maximum. Over the slope in contact it goes from "
      "{:.3f} to {:.3f}. On a smooth summit, where the slope in contact is evenly distributed, it "
      "is 2/\u221A3 = {:.3f}.",
      means.normalizedMu(0, last) / findPlateau(means, 0).value,
      shares.frictionOverSlope(0, kAtMaximum), shares.frictionOverSlope(0, kAtTheEnd),
      2 / std::numbers::sqrt3);
  return claim;
}

/// Returns the scene's curve around the velocity at which F_N / (4 eta v) is a tenth of h: two
/// decades on either side; the lower ones contain the maximum.
GroupedMeans meansAtBorder(const Scene& scene, FigureWork& work, double cost) {
  const double velocity = fewContactsVelocity(scene, scene.surface.rmsHeight);
  return work.computeMeans(scene, {scene.load.normalForce},
                           logSpaced(velocity / 100, velocity * 100, 33), cost);
}

/// Returns F_N / (4 eta v) over h where the curve falls below 95 % of its maximum.
double heightAtBorder(const GroupedMeans& means, int out = GroupedMeans::kAll) {
  const double height =
      summedContactHeight(means.normalForce(0), elementLaw(means.scene().elastomer).viscosity,
                          regionBorders(means, 0, out).offPlateau);
  return height / means.scene().surface.rmsHeight;
}

std::vector<GroupedMeans> meansAtForces(const GroupedMeans& means, FigureWork& work) {
  std::vector<GroupedMeans> allMeans;
  for (const double force : {0.01, 0.1, 1.0, 10.0}) {
    Scene scene = means.scene();
    scene.load.normalForce = forceAt(scene, force);
    allMeans.push_back(meansAtBorder(scene, work, 0.2));
  }
  return allMeans;
}

/// Returns longer and shorter periods under the same force per length. The roll-off keeps their
/// heights and slopes unchanged.
std::vector<GroupedMeans> meansAtLengths(const GroupedMeans& means, FigureWork& work) {
  const Surface& given = means.scene().surface;
  const double rollOff = given.rollOffWavelength > 0
                             ? std::min(given.rollOffWavelength, given.length / 4)
                             : given.length / 4;
  std::vector<GroupedMeans> allMeans;
  for (const double factor : {0.25, 1.0, 4.0}) {
    Scene scene = means.scene();
    scene.surface.length *= factor;
    scene.surface.elements = scaledElements(scene, factor);
    scene.surface.rollOffWavelength = rollOff;
    scene.load.normalForce *= factor;
    allMeans.push_back(meansAtBorder(scene, work, 2 * factor / 5.25));
  }
  return allMeans;
}

PrintedNumber lengthText(const GroupedMeans& means) {
  return printed(means.scene().surface.length, "m");
}

Claim borderClaim(const std::vector<GroupedMeans>& forces,
                  const std::vector<GroupedMeans>& lengths) {
  Claim claim{
      "region_4_begins_at_few_summits", "p. 4, after Eq. (15)",
      "The plateau decreases where the contact becomes extremely small, at extremely high "
      "sliding velocities or extremely low normal forces",
      "F\u2099 / (4 \u03B7 v) over h where region IV begins, geometric mean over four forces and "
      "three periods"};
  const auto mean = [&](int out) {
    double sum = 0;
    for (const std::vector<GroupedMeans>* allMeans : {&forces, &lengths})
      for (const GroupedMeans& means : *allMeans) sum += std::log(heightAtBorder(means, out));
    return std::exp(sum / static_cast<double>(forces.size() + lengths.size()));
  };
  claim.expected = kFewContactsHeight;
  claim.criterion =
      "0.03 to 0.3: the sum of the heights climbed by all contacts of one period is "
      "about a tenth of h";
  decide(claim, jackknife(forces.front().groups(), mean), {0.03, 0.3});
  std::vector<Message> each;
  for (const GroupedMeans& means : forces)
    each.push_back(message("F\u2099 / G h L = {:.2g}: {:.3f}",
                           dimensionlessForce(means.lawInput(0, 0)), heightAtBorder(means)));
  for (const GroupedMeans& means : lengths)
    each.push_back(message("L = {}: {:.3f}", lengthText(means), heightAtBorder(means)));
  claim.note = message("{}.", listed(each));
  return claim;
}

Claim lengthClaim(const std::vector<GroupedMeans>& allMeans) {
  Claim claim{"region_4_moves_with_length", "p. 1, abstract; p. 4, Eq. (17)",
              "The law of friction depends on the size of the system, which shifts the curves",
              "exponent n of v \u221D L\u207F where region IV begins, at given F\u2099 / L, h and "
              "roll-off"};
  const auto exponent = [&](int out) {
    std::vector<double> lengths, velocities;
    for (const GroupedMeans& means : allMeans) {
      lengths.push_back(means.scene().surface.length);
      velocities.push_back(regionBorders(means, 0, out).offPlateau);
    }
    return fitPower(lengths, velocities).slope;
  };
  claim.expected = 1;
  claim.criterion = "0.5 to 1.5; 1 by F\u2099 / (4 \u03B7 v) = 0.1 h";
  decide(claim, jackknife(allMeans.front().groups(), exponent), within(1, 0.5));
  std::vector<Message> each;
  for (const GroupedMeans& means : allMeans)
    each.push_back(
        message("L = {}: {:.2g} m/s", lengthText(means), regionBorders(means, 0).offPlateau));
  claim.note = message(
      "{}. Region IV belongs to the finite period: an endless line should keep its plateau.",
      listed(each));
  return claim;
}

}  // namespace

std::vector<Claim> regionClaims(const GroupedMeans& means, FigureWork& work) {
  const LoadShares shares = computeShares(means, work);
  const std::vector<GroupedMeans> forces = meansAtForces(means, work);
  const std::vector<GroupedMeans> lengths = meansAtLengths(means, work);
  return {viscousClaim(means, shares), followClaim(means, shares), borderClaim(forces, lengths),
          lengthClaim(lengths)};
}

}  // namespace asperity
