#include "core/friction/figures/zone_claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/friction/ensemble.h"
#include "core/friction/fit.h"

namespace asperity {
namespace {

/// Forces, as indices, that press a part of the line at the lowest velocity: Fbar <= 1.
std::size_t forcesInZone1(const Study& study) {
  std::size_t count = 0;
  while (count < study.forces() && dimensionlessForce(study.lawInput(count, 0)) <= 1) ++count;
  return count;
}

/// Exponent of `read` over the forces given by index.
template <class Read>
double forceExponentOf(const Study& study, const std::vector<std::size_t>& forces,
                       const Read& read) {
  std::vector<double> x, y;
  for (const std::size_t j : forces) {
    x.push_back(study.normalForce(j));
    y.push_back(read(j));
  }
  return fitPower(x, y).slope;
}

std::vector<std::size_t> firstForces(std::size_t count) {
  std::vector<std::size_t> forces(count);
  for (std::size_t j = 0; j < count; ++j) forces[j] = j;
  return forces;
}

Claim zone1Claim(const Study& study) {
  const std::vector<std::size_t> forces = firstForces(forcesInZone1(study));
  Claim claim{"zone_1_power", "p. 3, Eqs. (5) and (7)",
              "In zone 1 the coefficient of friction is a power of the force, "
              "mu ~ F_N^(-H/(1+H))",
              "exponent of mu over F_N at the lowest velocity, F_N / G h L up to 1"};
  if (forces.size() < 3) return claim;
  claim.measured = jackknife(study.groups(), [&](int out) {
    return forceExponentOf(study, forces, [&](std::size_t j) { return study.mu(j, 0, out); });
  });
  claim.expected = -forceExponent(study.scene().surface.hurst);
  claim.criterion = "within 0.03 of the expected";
  claim.holds = verdict(std::abs(claim.measured.value - claim.expected) < 0.03);
  return claim;
}

Claim contactLengthClaim(const Study& study) {
  const std::vector<std::size_t> forces = firstForces(forcesInZone1(study));
  Claim claim{"contact_length_power", "p. 3, before Eq. (7)",
              "At small forces the contact length is a power of the force, "
              "L_cont ~ F_N^(1/(1+H))",
              "exponent of L_cont over F_N at the lowest velocity, F_N / G h L up to 1"};
  if (forces.size() < 3) return claim;
  claim.measured = jackknife(study.groups(), [&](int out) {
    return forceExponentOf(study, forces,
                           [&](std::size_t j) { return study.contactFraction(j, 0, out); });
  });
  claim.expected = 1 / (1 + study.scene().surface.hurst);
  claim.criterion = "within 0.03 of the expected";
  claim.holds = verdict(std::abs(claim.measured.value - claim.expected) < 0.03);
  claim.note =
      "The slope in contact rises with the force, too, so that mu and L_cont need not "
      "have the same exponent up to 1.";
  return claim;
}

/// Eq. (6) holds on each line and for averages of mu against the pooled contact.
Claim contactLawClaim(const Study& study) {
  double worst = 0;
  for (std::size_t j = 0; j < study.forces(); ++j) {
    const double predicted = contactFriction(
        study.lawInput(j, 0), study.contactFraction(j, 0) * study.scene().surface.length,
        study.rmsSlopeContact(j, 0));
    worst = std::max(worst, std::abs(study.mu(j, 0) / predicted - 1));
  }
  Claim claim{"equation_6", "p. 3, Eq. (6)",
              "At low velocities mu = 4 L_cont eta grad_cont^2 v / F_N",
              "largest |mu / Eq. (6) - 1| at the lowest velocity, all forces"};
  claim.measured.value = worst;
  claim.expected = 0;
  claim.criterion = "below 0.02";
  claim.holds = verdict(worst < 0.02);
  return claim;
}

Claim slopeTrendClaim(const Study& study) {
  const std::size_t last = study.forces() - 1;
  Claim claim{"slope_in_contact_rises", "p. 4, Eq. (15)",
              "The rms slope in contact increases with the indentation, weakly",
              "rms slope in contact at the smallest force over that at the largest"};
  claim.measured = jackknife(study.groups(), [&](int out) {
    return study.rmsSlopeContact(0, 0, out) / study.rmsSlopeContact(last, 0, out);
  });
  bool rises = true;
  for (std::size_t j = 1; j <= last; ++j)
    rises &= study.rmsSlopeContact(j, 0) > 0.995 * study.rmsSlopeContact(j - 1, 0);
  claim.criterion = "below 1, and no force's slope falls by more than 0.5 %";
  claim.holds = verdict(claim.measured.value < 1 && rises);
  // Eq. (15) as printed has the wrong sign of the exponent; with q^(2(1-H)) it is the sum of modes
  // shorter than the contact.
  const double hurst = study.scene().surface.hurst;
  const double shortest =
      2 * study.scene().surface.length / static_cast<double>(study.scene().surface.elements);
  const auto squared = [&](double contact) {
    return 1 - std::pow(shortest / contact, 2 * (1 - hurst));
  };
  const double length = study.scene().surface.length;
  const double predicted =
      hurst < 1 ? std::sqrt(squared(study.contactFraction(0, 0) * length) / squared(length))
                : kNotApplicable;
  claim.expected = predicted;
  claim.note =
      "Eq. (15)'s exponents must read +2(1 - H). With them, and q_cont = 2 pi / L_cont for the "
      "whole contact taken as one piece, it gives the expected value; the real contact is in many "
      "pieces, which are shorter.";
  return claim;
}

Claim plateauSpreadClaim(const Study& study) {
  std::vector<double> tops;
  for (std::size_t j = 0; j < study.forces(); ++j) tops.push_back(plateauOf(study, j).normalizedMu);
  Claim claim{"plateau_depends_weakly_on_force", "p. 1, abstract",
              "The coefficient of friction on the plateau depends only weakly on the normal force",
              "smallest over largest plateau, over five decades of force"};
  const auto [low, high] = std::minmax_element(tops.begin(), tops.end());
  const auto lowest = static_cast<std::size_t>(low - tops.begin());
  const auto highest = static_cast<std::size_t>(high - tops.begin());
  claim.measured = jackknife(study.groups(), [&](int out) {
    return plateauOf(study, lowest, out).normalizedMu / plateauOf(study, highest, out).normalizedMu;
  });
  claim.expected = 1;
  claim.criterion = "above 0.8";
  claim.holds = verdict(claim.measured.value > 0.8);
  return claim;
}

/// Horizontal shift (in ln v) of each curve so that region I lies on that of the first; what is
/// left between the curves up to their plateaus.
Claim shiftClaim(const Study& study) {
  const double reference = study.mu(0, 0);
  double worst = 0;
  for (std::size_t j = 1; j < study.forces(); ++j) {
    const double shift = reference / study.mu(j, 0);
    const double end = plateauOf(study, 0).velocity;
    for (const double velocity : logSpaced(study.velocities()[0], end, 40)) {
      const double moved = velocity * shift;
      if (moved > study.velocities().back()) break;
      worst = std::max(worst, std::abs(std::log10(normalizedMuAt(study, j, moved) /
                                                  normalizedMuAt(study, 0, velocity))));
    }
  }
  Claim claim{"curves_shift", "p. 2, Fig. 4",
              "The form of the dependence is approximately the same for different forces, only "
              "shifted along the axis of log v",
              "largest distance of two curves (decades of mu), shifted together in region I, up to "
              "the plateau"};
  claim.measured.value = worst;
  claim.expected = 0;
  claim.criterion = "below 0.1 (26 %)";
  claim.holds = verdict(worst < 0.1);
  return claim;
}

Claim ratioClaim(const Study& study, FigureWork& work) {
  Scene scene = study.scene();
  scene.elastomer.shearModulus *= 3;
  scene.ensemble.realizations = std::min<std::int64_t>(study.realizations(), 10);
  const std::vector<double> velocities{1e-3, 1e-1, 10};
  std::vector<double> forces;
  for (std::size_t j = 0; j < study.forces(); j += 6) forces.push_back(study.normalForce(j));
  std::vector<double> larger = forces;
  for (double& force : larger) force *= 3;
  Scene plain = study.scene();
  plain.ensemble.realizations = scene.ensemble.realizations;
  const Study one = work.study(plain, forces, velocities, 1);
  const Study three = work.study(scene, larger, velocities, 1);
  double worst = 0;
  for (std::size_t j = 0; j < forces.size(); ++j)
    for (std::size_t i = 0; i < velocities.size(); ++i)
      worst = std::max(worst, std::abs(three.mu(j, i) / one.mu(j, i) - 1));
  Claim claim{"force_over_modulus", "p. 2, before Eq. (5)",
              "The coefficient of friction depends on force and shear modulus only over F_N / G",
              "largest change of mu where both are tripled"};
  claim.measured.value = worst;
  claim.expected = 0;
  claim.criterion = "below 1e-9";
  claim.holds = verdict(worst < 1e-9);
  return claim;
}

/// mu ~ grad^n at fixed h, by the spacing.
Claim slopeSquaredClaim(const Study& study, FigureWork& work) {
  std::vector<Study> studies;
  for (const double factor : {0.5, 1.0, 2.0, 4.0}) {
    Scene scene = study.scene();
    scene.surface.elements = std::max<std::int64_t>(
        3, std::llround(factor * static_cast<double>(scene.surface.elements)));
    studies.push_back(work.study(scene, {forceAt(scene, 0.1)}, {study.velocities()[0]}, 2));
  }
  Claim claim{
      "slope_squared", "p. 2, before Eq. (5)",
      "At low velocities the coefficient of friction is very accurately proportional to the "
      "squared rms gradient, varied by the spacing",
      "exponent n of mu ~ grad^n at F_N / G h L = 0.1"};
  claim.measured = jackknife(study.groups(), [&](int out) {
    std::vector<double> slopes, mu;
    for (const Study& one : studies) {
      slopes.push_back(one.line().rmsSlope);
      mu.push_back(one.mu(0, 0, out));
    }
    return fitPower(slopes, mu).slope;
  });
  claim.expected = 2;
  claim.criterion = "within 0.1 of 2";
  claim.holds = verdict(std::abs(claim.measured.value - 2) < 0.1);
  return claim;
}

Claim completeContactClaim(const Study& study) {
  double force = kNotApplicable;
  for (std::size_t j = 0; j < study.forces() && !std::isfinite(force); ++j)
    if (study.contactFraction(j, 0) > 0.9) force = dimensionlessForce(study.lawInput(j, 0));
  Claim claim{
      "complete_contact_near_1", "p. 3, after Eq. (14)",
      "F_N / G h L of about 1 gives the order of magnitude of the force of complete contact",
      "first F_N / G h L of the twenty with more than 90 % of the line in contact"};
  claim.measured.value = force;
  claim.expected = 1;
  claim.criterion = "between 0.1 and 10";
  claim.holds = verdict(force > 0.1 && force < 10);
  return claim;
}

}  // namespace

std::vector<Claim> zoneClaims(const Study& study, FigureWork& work) {
  return {shiftClaim(study),
          zone1Claim(study),
          fullContactClaim({&study, 1}),
          ratioClaim(study, work),
          slopeSquaredClaim(study, work),
          contactLawClaim(study),
          contactLengthClaim(study),
          slopeTrendClaim(study),
          plateauSpreadClaim(study),
          completeContactClaim(study)};
}

}  // namespace asperity
