#include "tests/stability/invariants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/contact/steady_sweep.h"

namespace asperity {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr std::size_t kMaxNodes = 100000;  // above, only what one result says
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double relative(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return kInfinity;
  if (a == b) return 0;
  return std::abs(a - b) / std::max(std::abs(a), std::abs(b));
}

PreparedProfile profileOf(const Situation& situation) {
  return prepareProfile(situation.line, situation.scheme);
}

double highestOf(const PreparedProfile& profile) {
  return *std::max_element(profile.heightAboveMinimum.begin(), profile.heightAboveMinimum.end());
}

Line moved(const Line& line, std::size_t nodes) {
  Line other = line;
  for (std::vector<double>* values : {&other.height, &other.slopeAfter, &other.slopeBefore})
    if (!values->empty())
      std::rotate(values->begin(), values->begin() + static_cast<std::ptrdiff_t>(nodes),
                  values->end());
  return other;
}

Situation scaled(const Situation& situation, double heights, double lengths, double modulus,
                 double time) {
  Situation other = situation;
  for (double& height : other.line.height) height *= heights;
  for (std::vector<double>* slopes : {&other.line.slopeAfter, &other.line.slopeBefore})
    for (double& slope : *slopes) slope *= heights / lengths;
  other.line.length *= lengths;
  other.line.spacing *= lengths;
  other.line.rmsHeight *= heights;
  other.line.rmsSlope *= heights / lengths;
  other.conditions.shearModulus *= modulus;
  other.conditions.relaxationTime *= time;
  other.conditions.velocity *= lengths / time;
  other.load.normalForce *= modulus * heights * lengths;
  other.load.depth *= heights;
  return other;
}

/// Relative. Heights are known to an ulp of the largest, and contact may reach as little of them as
/// the free surface comes back over a period.
double heightNoise(const Situation& situation, double indentation) {
  const auto [low, high] =
      std::minmax_element(situation.line.height.begin(), situation.line.height.end());
  const double memory = situation.conditions.velocity * situation.conditions.relaxationTime;
  const double reach = indentation / (1 + memory / situation.line.length);
  return reach > 0 ? 16 * kEpsilon * (*high - *low) / reach : 0;
}

/// How far two mu that should be the same are apart. Elements one by one give the difference of
/// large terms, whose scale is the slope.
double apart(const Situation& situation, double a, double b) {
  if (std::isnan(a) && std::isnan(b)) return 0;  // pressed by nothing, both
  if (!std::isfinite(a) || !std::isfinite(b)) return kInfinity;
  const double floor = situation.scheme == Scheme::Nodal ? 1e-3 : 1e-15;
  const double scale = std::max(std::abs(a), std::abs(b)) + floor * situation.line.rmsSlope;
  return a == b ? 0 : std::abs(a - b) / scale;
}

}  // namespace

double Finding::share() const {
  if (!std::isfinite(value)) return kInfinity;
  if (value <= 0) return 0;
  return allowed > 0 ? value / allowed : kInfinity;
}

SteadyResult solve(const Situation& situation, Path path) {
  const PreparedProfile profile = profileOf(situation);
  if (path == Path::Plain) return slideAtLoad(profile, situation.conditions, situation.load);
  std::array<SteadyResult, 1> results;
  const std::array<double, 1> velocities{situation.conditions.velocity};
  slideSweep(profile, situation.conditions, situation.load, velocities, results);
  return results[0];
}

bool isRefused(const SteadyResult& result) {
  return result.status != SteadyStatus::Balanced;
}

std::vector<Finding> resultFindings(const Situation& situation, const SteadyResult& result) {
  const bool nodal = situation.scheme == Scheme::Nodal;
  std::vector<Finding> findings;
  double infinite = 0;
  for (const double value : {result.indentation, result.normalForce, result.tangentialForce,
                             result.mu, result.contactFraction, result.marginalShare})
    infinite += std::isfinite(value) ? 0 : 1;
  findings.push_back({"finite", infinite, 0});
  const double fraction = result.contactFraction;
  findings.push_back({"contact fraction in 0..1", fraction >= 0 && fraction <= 1 ? 0.0 : 1.0, 0});
  if (situation.load.kind == LoadKind::Force)
    findings.push_back({"force balance", relative(result.normalForce, situation.load.normalForce),
                        kAcceptedResidual});
  if (nodal) {
    const bool inside = result.marginalShare >= 0 && result.marginalShare <= 1;
    findings.push_back({"marginal share in 0..1", inside ? 0.0 : 1.0, 0});
    return findings;
  }
  const double allowed = 1e-9 + heightNoise(situation, result.indentation);
  findings.push_back(
      {"both ways to F_N", relative(result.forceFromDepth, result.forceFromPressure), allowed});
  findings.push_back({"mu >= 0", result.mu >= 0 ? 0.0 : 1.0, 0});
  if (std::isfinite(result.powerIn)) {
    // At rest both are nothing but rounding, which is measured by the force.
    const double scale =
        std::max(result.powerDissipated, result.normalForce * situation.line.rmsSlope *
                                             situation.conditions.velocity * 1e-3);
    const double apart = std::abs(result.powerIn - result.powerDissipated);
    findings.push_back({"power balance", apart == 0 ? 0 : apart / scale, allowed});
  }
  return findings;
}

std::vector<Finding> shapeFindings(const Situation& situation, double indentation) {
  const PreparedProfile profile = profileOf(situation);
  const NodeShape shape = shapeAt(profile, situation.conditions, indentation);
  const double ulp = highestOf(profile) * kEpsilon;
  double negative = 0, through = 0, both = 0, infinite = 0;
  for (std::size_t i = 0; i < shape.depth.size(); ++i) {
    infinite += std::isfinite(shape.depth[i]) && std::isfinite(shape.pressure[i]) ? 0 : 1;
    const double gap =
        shape.depth[i] - (indentation - profile.heightAboveMinimum[i]);  // (z - d) - u
    negative = std::max({negative, -shape.pressure[i], -shape.depth[i]});
    through = std::max(through, -gap);
    if (shape.pressure[i] > 0) both = std::max(both, gap);
  }
  return {
      {"shape finite", infinite, 0},
      {"p >= 0, u <= 0", negative, 0},
      {"u <= z - d (ulp of max z)", ulp > 0 ? through / ulp : (through > 0 ? kInfinity : 0.0), 4},
      {"p (z - d - u) = 0", ulp > 0 ? both / ulp : (both > 0 ? kInfinity : 0.0), 4}};
}

Finding forceGrowsWithDepth(const Situation& situation, double indentation) {
  const PreparedProfile profile = profileOf(situation);
  double worst = 0, last = 0;
  for (const double factor : {0.25, 0.5, 0.9, 1 - 1e-9, 1.0, 1 + 1e-9, 1.1, 2.0, 4.0}) {
    const double force =
        slideAtDepth(profile, situation.conditions, indentation * factor).normalForce;
    if (!std::isfinite(force)) return {"F_N grows with d", kInfinity, 0};
    if (force < last) worst = std::max(worst, (last - force) / last);
    last = force;
  }
  return {"F_N grows with d", worst, 1e-12 + heightNoise(situation, indentation)};
}

Finding exactScaling(const Situation& situation, Path path, double mu) {
  const Situation other = scaled(situation, 8, 4, 2, 16);
  const double wanted = mu * 2;
  const double found = solve(other, path).mu;
  const bool denormal = std::abs(wanted) < 1e-290;  // the arithmetic does not allow it there
  return {"scaling by powers of two", denormal ? 0 : relative(found, wanted), 0};
}

Finding shiftSymmetry(const Situation& situation, Path path, const SteadyResult& result) {
  Situation other = situation;
  other.line = moved(situation.line, situation.line.nodes() / 3);
  const SteadyResult shifted = solve(other, path);
  const double residual = shifted.residual + result.residual;
  return {"shift along x", apart(situation, shifted.mu, result.mu),
          1e-12 + 4 * residual + heightNoise(situation, result.indentation)};
}

std::vector<Finding> allFindings(const Situation& situation) {
  std::vector<Finding> findings;
  const auto add = [&findings](std::vector<Finding> more) {
    findings.insert(findings.end(), more.begin(), more.end());
  };
  for (const Path path : {Path::Plain, Path::Lanes}) {
    const SteadyResult result = solve(situation, path);
    // Elements one by one may touch at a depth without being pressed: there is no mu then.
    if (isRefused(result) || result.normalForce == 0) return {};
    add(resultFindings(situation, result));
    if (situation.line.nodes() > kMaxNodes) continue;
    add({exactScaling(situation, path, result.mu), shiftSymmetry(situation, path, result)});
    if (path == Path::Lanes) continue;
    add(shapeFindings(situation, result.indentation));
    add({forceGrowsWithDepth(situation, result.indentation)});
  }
  return findings;
}

Finding worstOf(const std::vector<Finding>& findings) {
  const auto worst =
      std::max_element(findings.begin(), findings.end(),
                       [](const Finding& a, const Finding& b) { return a.share() < b.share(); });
  return worst == findings.end() ? Finding{} : *worst;
}

}  // namespace asperity
