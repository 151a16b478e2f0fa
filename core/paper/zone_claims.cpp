#include "core/paper/figure_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.h"
#include "core/friction/curve_features.h"
#include "core/friction/ensemble.h"
#include "core/paper/load_shares.h"

namespace asperity {
namespace {

/// Returns the forces of zone 1, as indices.
std::vector<std::size_t> forcesInZone1(const GroupedMeans& means) {
  std::vector<std::size_t> forces;
  for (std::size_t j = 0; j < means.forces(); ++j)
    if (isInZone1(dimensionlessForce(means.lawInput(j, 0)))) forces.push_back(j);
  return forces;
}

/// Returns the exponent of `read` over the forces given by index.
template <class Read>
double exponentOverForces(const GroupedMeans& means, const std::vector<std::size_t>& forces,
                          const Read& read) {
  std::vector<double> x, y;
  for (const std::size_t j : forces) {
    x.push_back(means.normalForce(j));
    y.push_back(read(j));
  }
  return fitPower(x, y).slope;
}

/// Returns an exponent over the forces of zone 1, in the same window as alpha in Fig. 5.
template <class Read>
Claim zone1Claim(Claim claim, const GroupedMeans& means, double expected, const Read& read) {
  const std::vector<std::size_t> forces = forcesInZone1(means);
  claim.expected = expected;
  claim.criterion = "within 0.03 of the expected";
  if (forces.size() < 3) return claim;
  const auto exponent = [&](int out) {
    return exponentOverForces(means, forces, [&](std::size_t j) { return read(j, out); });
  };
  decide(claim, jackknife(means.groups(), exponent), within(expected, 0.03));
  return claim;
}

Claim zone1FrictionClaim(const GroupedMeans& means) {
  return zone1Claim(
      {"zone_1_power", "p. 3, Eqs. (5) and (7)",
       "In zone 1 the coefficient of friction is a power of the force, with exponent "
       "\u2212H/(1 + H)",
       "exponent of \u03BC over F\u2099 at the lowest velocity, F\u2099 / G h L up to 0.1"},
      means, -forceExponent(hurstExponent(means)),
      [&](std::size_t j, int out) { return means.mu(j, 0, out); });
}

Claim contactLengthClaim(const GroupedMeans& means) {
  Claim claim = zone1Claim(
      {"contact_length_power", "p. 3, before Eq. (7)",
       "At small forces the contact length is a power of the force, with the exponent 1/(1+H)",
       "exponent of the contact length over F\u2099 at the lowest velocity, F\u2099 / G h L up to "
       "0.1"},
      means, 1 / (1 + hurstExponent(means)),
      [&](std::size_t j, int out) { return means.contactFraction(j, 0, out); });
  claim.note =
      "The slope in contact rises with the force, too, so that \u03BC and the contact length need "
      "not have the same exponent up to 1.";
  return claim;
}

/// Returns the claim on Eq. (6), on each line and for averages of mu compared with the pooled
/// contact.
Claim contactLawClaim(const GroupedMeans& means) {
  Claim claim{
      "equation_6", "p. 3, Eq. (6)",
      "At low velocities \u03BC is 4 \u03B7 v / F\u2099 times the contact length and the squared "
      "rms slope in contact",
      "largest |\u03BC / Eq. (6) - 1| at the lowest velocity, all forces"};
  const auto deviation = [&](std::size_t j, int out) {
    const double predicted = contactFriction(
        means.lawInput(j, 0), means.contactFraction(j, 0, out) * means.scene().surface.length,
        means.rmsSlopeContact(j, 0, out));
    return std::abs(means.mu(j, 0, out) / predicted - 1);
  };
  std::vector<Estimate> deviations;
  for (std::size_t j = 0; j < means.forces(); ++j)
    deviations.push_back(jackknife(means.groups(), [&](int out) { return deviation(j, out); }));
  claim.expected = 0;
  decideByAll(claim, deviations, below(0.02));
  return claim;
}

/// Returns the rms slope in contact at force j over that at force k, at the lowest velocity.
Estimate slopeRatio(const GroupedMeans& means, std::size_t j, std::size_t k) {
  return jackknife(means.groups(), [&](int out) {
    return means.rmsSlopeContact(j, 0, out) / means.rmsSlopeContact(k, 0, out);
  });
}

Claim slopeTrendClaim(const GroupedMeans& means) {
  const std::size_t last = means.forces() - 1;
  Claim claim{"slope_in_contact_rises", "p. 4, Eq. (15)",
              "The rms slope in contact increases with the indentation, weakly",
              "rms slope in contact at the smallest force over that at the largest"};
  decide(claim, slopeRatio(means, 0, last), below(1));
  // Eq. (15) as printed has the wrong sign of the exponent; with q^(2(1-H)) it is the sum of modes
  // shorter than the contact.
  const double hurst = hurstExponent(means);
  const double shortest =
      2 * means.scene().surface.length / static_cast<double>(means.scene().surface.elements);
  const auto squared = [&](double contact) {
    return 1 - std::pow(shortest / contact, 2 * (1 - hurst));
  };
  const double length = means.scene().surface.length;
  const double predicted =
      hurst < 1 ? std::sqrt(squared(means.contactFraction(0, 0) * length) / squared(length))
                : kNotApplicable;
  claim.expected = predicted;
  claim.note =
      "Eq. (15)'s exponents must read +2(1 - H). With them, and with the whole contact taken as "
      "one piece, whose length is the longest wave in contact, it gives the expected value; the "
      "real contact is in many "
      "pieces, which are shorter.";
  return claim;
}

/// Returns the claim on a line whose summits are rougher than its other parts.
Claim roughSummitsClaim(const GroupedMeans& means, FigureWork& work) {
  constexpr double kCorrelation = 2;
  Scene scene = means.scene();
  scene.surface.summitCorrelation = kCorrelation;
  const std::size_t last = means.forces() - 1;
  const GroupedMeans rough = work.computeMeans(
      scene, {means.normalForce(0), means.normalForce(last)}, {means.velocities()[0]}, 1);
  Claim claim{"slope_in_contact_falls_for_rough_summits", "p. 4, after Eq. (15)",
              "For a surface that is rougher on the summits than on the slopes the rms slope would "
              "decrease with indentation",
              "rms slope in contact at the smallest force over that at the largest, with "
              "a summit correlation of 2"};
  decide(claim, slopeRatio(rough, 0, 1), above(1));
  claim.note = message("With a summit correlation of {:g} it is {:.3f}.",
                       means.scene().surface.summitCorrelation, slopeRatio(means, 0, last).value);
  return claim;
}

/// Returns the velocity (m/s) at which the trailing sides of the summits still carry this part of
/// the load, by linear interpolation in logarithms between the velocities of case j; NaN: none.
double velocityOfTrailing(const LoadShares& shares, std::size_t j, double part, int out) {
  const std::vector<double>& v = shares.loadCase(j).velocities;
  for (std::size_t i = 0; i + 1 < v.size(); ++i) {
    const double here = shares.trailing(j, i, out), next = shares.trailing(j, i + 1, out);
    if (here >= part && next < part && next > 0)
      return v[i] * std::pow(v[i + 1] / v[i], std::log(here / part) / std::log(here / next));
  }
  return kNotApplicable;
}

Claim oneSidedClaim(const GroupedMeans& means, FigureWork& work) {
  constexpr double kPart = 0.1;
  constexpr std::array kForces{0.01, 0.1, 1.0, 10.0, 100.0};  // F_N / G h L
  constexpr std::size_t kPartial = 3;                         // index of one in partial contact
  const Scene& scene = means.scene();
  const double unit = velocityAt(1, scene, means.line().rmsSlope);
  std::vector<LoadCase> cases;
  for (const double force : kForces) {
    const double meeting = meetingVelocity(force, scene.surface.hurst) * unit;
    cases.push_back(atForce(forceAt(scene, force), logSpaced(0.1 * meeting, 20 * meeting, 9)));
  }
  const LoadShares shares(scene, std::move(cases), std::min<std::int64_t>(means.realizations(), 40),
                          work.next(2));
  std::vector<Estimate> velocities;
  for (std::size_t j = 0; j < kForces.size(); ++j)
    velocities.push_back(jackknife(shares.groups(), [&](int out) {
      return velocityOfTrailing(shares, j, kPart, out) / unit;
    }));
  Claim claim{
      "contacts_one_sided_at_1", "p. 3, after Eq. (14)",
      "Dimensionless velocity of about 1 gives the order of magnitude of the velocity at "
      "which the elastomer is detached on the trailing side of any asperity and all the "
      "contacts become one-sided",
      "dimensionless velocity at which trailing sides carry a tenth of the load, F\u2099 / G h "
      "L = 0.01, 0.1 and 1: the most distant"};
  claim.expected = 1;
  decideByAll(claim, {velocities.data(), kPartial}, between(0.1, 10));
  std::vector<Message> each;
  for (std::size_t j = 0; j < kForces.size(); ++j)
    each.push_back(message("F\u2099 / G h L = {:g}: {:.2g}", kForces[j], velocities[j].value));
  claim.note = message(
      "{}. In complete contact it grows as the force. The detachment condition of the paper lacks "
      "a factor G: G (d - z) + \u03B7 v z\u2032 = 0.",
      listed(each));
  return claim;
}

Claim plateauSpreadClaim(const GroupedMeans& means) {
  std::vector<double> tops;
  for (std::size_t j = 0; j < means.forces(); ++j) tops.push_back(findPlateau(means, j).value);
  Claim claim{"plateau_depends_weakly_on_force", "p. 1, abstract",
              "The coefficient of friction on the plateau depends only weakly on the normal force",
              "smallest over largest plateau, over five decades of force"};
  const auto [low, high] = std::minmax_element(tops.begin(), tops.end());
  const auto lowest = static_cast<std::size_t>(low - tops.begin());
  const auto highest = static_cast<std::size_t>(high - tops.begin());
  claim.expected = 1;
  const auto ratio = [&](int out) {
    return findPlateau(means, lowest, out).value / findPlateau(means, highest, out).value;
  };
  decide(claim, jackknife(means.groups(), ratio), above(0.8));
  return claim;
}

/// Returns the remaining distance between the curves up to their plateaus (decades of mu) after
/// each has been shifted along ln v so that its region I lies on that of the first.
double distanceOfShifted(const GroupedMeans& means, int out) {
  const double reference = means.mu(0, 0, out);
  const double end = findPlateau(means, 0, out).x;
  double worst = 0;
  for (std::size_t j = 1; j < means.forces(); ++j) {
    const double shift = reference / means.mu(j, 0, out);
    for (const double velocity : logSpaced(means.velocities()[0], end, 40)) {
      const double moved = velocity * shift;
      if (moved > means.velocities().back()) break;
      worst = std::max(worst, std::abs(std::log10(normalizedMuAt(means, j, moved, out) /
                                                  normalizedMuAt(means, 0, velocity, out))));
    }
  }
  return worst;
}

Claim shiftClaim(const GroupedMeans& means) {
  Claim claim{
      "curves_shift", "p. 2, Fig. 4",
      "The form of the dependence is approximately the same for different forces, only "
      "shifted along the axis of log v",
      "largest distance of two curves (decades of \u03BC), shifted together in region I, up to "
      "the plateau"};
  claim.expected = 0;
  claim.criterion = "below 0.1 (26 %)";
  decide(claim, jackknife(means.groups(), [&](int out) { return distanceOfShifted(means, out); }),
         below(0.1));
  return claim;
}

Claim ratioClaim(const GroupedMeans& means, FigureWork& work) {
  Scene scene = means.scene();
  scene.elastomer.shearModulus *= 3;
  scene.ensemble.realizations = std::min<std::int64_t>(means.realizations(), 10);
  const std::vector<double> velocities{1e-3, 1e-1, 10};
  std::vector<double> forces;
  for (std::size_t j = 0; j < means.forces(); j += 6) forces.push_back(means.normalForce(j));
  std::vector<double> larger = forces;
  for (double& force : larger) force *= 3;
  Scene asGiven = means.scene();
  asGiven.ensemble.realizations = scene.ensemble.realizations;
  const GroupedMeans one = work.computeMeans(asGiven, forces, velocities, 1);
  const GroupedMeans three = work.computeMeans(scene, larger, velocities, 1);
  double worst = 0;
  for (std::size_t j = 0; j < forces.size(); ++j)
    for (std::size_t i = 0; i < velocities.size(); ++i)
      worst = std::max(worst, std::abs(three.mu(j, i) / one.mu(j, i) - 1));
  Claim claim{
      "force_over_modulus", "p. 2, before Eq. (5)",
      "The coefficient of friction depends on force and shear modulus only over F\u2099 / G",
      "largest change of \u03BC where both are tripled"};
  decideZero(claim, worst);
  return claim;
}

/// Returns the claim mu ~ grad^n at fixed h, from different spacings.
Claim slopeSquaredClaim(const GroupedMeans& means, FigureWork& work) {
  std::vector<GroupedMeans> allMeans;
  for (const double factor : {0.5, 1.0, 2.0, 4.0}) {
    Scene scene = means.scene();
    scene.surface.elements = scaledElements(scene, factor);
    allMeans.push_back(work.computeMeans(scene, {forceAt(scene, 0.1)}, {means.velocities()[0]}, 2));
  }
  Claim claim{
      "slope_squared", "p. 2, before Eq. (5)",
      "At low velocities the coefficient of friction is very accurately proportional to the "
      "squared rms gradient, varied by the spacing",
      "exponent n of \u03BC \u221D grad\u207F at F\u2099 / G h L = 0.1"};
  claim.expected = 2;
  const auto exponent = [&](int out) {
    return slopeExponent(allMeans, [&](const GroupedMeans& one) { return one.mu(0, 0, out); });
  };
  decide(claim, jackknife(means.groups(), exponent), within(2, 0.1));
  return claim;
}

/// Returns F_N / G h L at which this part of the line is in contact at the lowest velocity, by
/// interpolation in the logarithm of the force; NaN: at none of the forces.
double forceOfContact(const GroupedMeans& means, double part, int out) {
  for (std::size_t j = 0; j + 1 < means.forces(); ++j) {
    const double here = means.contactFraction(j, 0, out),
                 next = means.contactFraction(j + 1, 0, out);
    if (here > part || next <= part) continue;
    return dimensionlessForce(means.lawInput(j, 0)) *
           std::pow(means.normalForce(j + 1) / means.normalForce(j), (part - here) / (next - here));
  }
  return kNotApplicable;
}

Claim completeContactClaim(const GroupedMeans& means) {
  Claim claim{
      "complete_contact_near_1", "p. 3, after Eq. (14)",
      "F\u2099 / G h L of about 1 gives the order of magnitude of the force of complete contact",
      "F\u2099 / G h L at which 90 % of the line are in contact, at the lowest velocity"};
  claim.expected = 1;
  decide(claim, jackknife(means.groups(), [&](int out) { return forceOfContact(means, 0.9, out); }),
         between(0.1, 10));
  return claim;
}

}  // namespace

std::vector<Claim> zoneClaims(const GroupedMeans& means, FigureWork& work) {
  return {
      shiftClaim(means),          zone1FrictionClaim(means),      fullContactClaim({&means, 1}),
      ratioClaim(means, work),    slopeSquaredClaim(means, work), contactLawClaim(means),
      contactLengthClaim(means),  slopeTrendClaim(means),         roughSummitsClaim(means, work),
      oneSidedClaim(means, work), plateauSpreadClaim(means),      completeContactClaim(means)};
}

}  // namespace asperity
