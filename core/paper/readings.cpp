#include "core/paper/readings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/friction/curve_features.h"
#include "core/friction/ensemble.h"

namespace asperity {
namespace {

std::vector<double> normalizedCurve(const GroupedMeans& means, std::size_t j, int leftOut) {
  std::vector<double> values;
  for (std::size_t i = 0; i < means.velocities(j).size(); ++i)
    values.push_back(means.normalizedMu(j, i, leftOut));
  return values;
}

}  // namespace

double velocityExponent(const GroupedMeans& means, std::size_t j, std::size_t first,
                        std::size_t last, int leftOut) {
  std::vector<double> velocities, mu;
  for (std::size_t i = first; i <= last; ++i) {
    velocities.push_back(means.velocities(j)[i]);
    mu.push_back(means.mu(j, i, leftOut));
  }
  return fitPower(velocities, mu).slope;
}

Plateau findPlateau(const GroupedMeans& means, std::size_t j, int leftOut) {
  const CurveMaximum maximum =
      curveMaximum(means.velocities(j), normalizedCurve(means, j, leftOut));
  return {maximum.velocity, maximum.value};
}

RegionBorders regionBorders(const GroupedMeans& means, std::size_t j, int leftOut,
                            const BorderRule& rule) {
  return regionBorders(means.velocities(j), normalizedCurve(means, j, leftOut), rule);
}

double normalizedMuAt(const GroupedMeans& means, std::size_t j, double velocity, int leftOut) {
  const std::vector<double>& velocities = means.velocities(j);
  const auto above = std::upper_bound(velocities.begin() + 1, velocities.end() - 1, velocity);
  const auto i = static_cast<std::size_t>(above - velocities.begin());
  const double part =
      std::log(velocity / velocities[i - 1]) / std::log(velocities[i] / velocities[i - 1]);
  const double before = means.normalizedMu(j, i - 1, leftOut);
  return before * std::pow(means.normalizedMu(j, i, leftOut) / before, part);
}

double lowVelocityFactor(const GroupedMeans& means, std::size_t j, std::size_t i, int leftOut) {
  const LawInput in = means.lawInput(j, i);
  return means.mu(j, i, leftOut) * in.rmsHeight /
         (in.relaxationTime * in.velocity * in.rmsSlope * in.rmsSlope);
}

double velocityAt(double dimensionlessVelocity, const Scene& scene, double rmsSlope) {
  return dimensionlessVelocity * std::numbers::sqrt2 * scene.surface.rmsHeight /
         (scene.elastomer.relaxationTime * rmsSlope);
}

double meetingVelocity(double dimensionlessForce, double hurst) {
  return std::hypot(dimensionlessForce / 4,
                    std::pow(dimensionlessForce, forceExponent(hurst)) / lawPrefactor(hurst));
}

bool isInZone1(double dimensionlessForce, double to) {
  constexpr double kRounding = 1e-9;
  return dimensionlessForce >= kZone1From * (1 - kRounding) &&
         dimensionlessForce <= to * (1 + kRounding);
}

FullContact compareFullContact(const GroupedMeans& means) {
  FullContact found;
  for (std::size_t j = 0; j < means.forces(); ++j)
    for (std::size_t i = 0; i < means.velocities(j).size(); ++i) {
      if (means.contactFraction(j, i) < 1 - 1e-12) continue;
      ++found.points;
      LawInput in = means.lawInput(j, i);
      const auto deviation = [&] { return std::abs(means.mu(j, i) / fullContactFriction(in) - 1); };
      found.toSpectral = std::max(found.toSpectral, deviation());
      in.rmsSlope = means.rmsSlopeContact(j, i);
      found.toResolved = std::max(found.toResolved, deviation());
    }
  return found;
}

double forceAt(const Scene& scene, double dimensionlessForce) {
  return dimensionlessForce * scene.elastomer.shearModulus * scene.surface.rmsHeight *
         scene.surface.length;
}

double fitAlpha(const GroupedMeans& means, int leftOut, double to) {
  std::vector<double> forces, factors;
  for (std::size_t j = 0; j < means.forces(); ++j) {
    const double force = dimensionlessForce(means.lawInput(j, 0));
    if (!isInZone1(force, to)) continue;
    forces.push_back(force);
    factors.push_back(lowVelocityFactor(means, j, 0, leftOut));
  }
  return -fitPower(forces, factors).slope;
}

double fitBeta(const GroupedMeans& means, int leftOut) {
  const double alpha = forceExponent(means.scene().surface.hurst);
  double sum = 0;
  for (std::size_t j = 0; j < means.forces(); ++j) {
    const double force = dimensionlessForce(means.lawInput(j, 0));
    sum += std::log(lowVelocityFactor(means, j, 0, leftOut)) + alpha * std::log(force);
  }
  return std::exp(sum / static_cast<double>(means.forces()));
}

std::vector<LoadCase> zone1Cases(const Scene& scene, double rmsSlope) {
  std::vector<LoadCase> cases;
  for (const double force : logSpaced(kZone1From, kBetaUpTo, 13))
    cases.push_back(
        {{LoadKind::Force, forceAt(scene, force), 0}, {velocityAt(1e-5, scene, rmsSlope)}});
  return cases;
}

std::vector<LoadCase> plateauCases(const Scene& scene, double rmsSlope,
                                   const std::vector<double>& normalForces) {
  std::vector<LoadCase> cases;
  for (const double normalForce : normalForces) {
    // The maximum lies one to two decades above the velocity where region I meets the plateau.
    const double meeting = meetingVelocity(normalForce / forceAt(scene, 1), scene.surface.hurst);
    const double velocity = velocityAt(meeting, scene, rmsSlope);
    cases.push_back(
        {{LoadKind::Force, normalForce, 0}, logSpaced(3 * velocity, 300 * velocity, 9)});
  }
  return cases;
}

}  // namespace asperity
