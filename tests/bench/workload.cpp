#include "tests/bench/workload.h"

#include <cmath>
#include <stdexcept>

#include "core/contact/steady_sweep.h"
#include "core/friction/ensemble.h"
#include "tests/bench/line_store.h"

namespace asperity::bench {
namespace {

void count(const SteadyResult& result, Tally& tally) {
  if (result.status != SteadyStatus::Balanced)
    throw std::runtime_error("a force balance of the benchmark is not met");
  tally.passes += result.passes;
  tally.contactFraction += result.contactFraction;
}

}  // namespace

std::vector<double> logarithmic(double low, double high, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
    values.push_back(low * std::pow(high / low, i / static_cast<double>(count - 1)));
  return values;
}

const std::vector<double>& figure2Velocities() {
  static const std::vector<double> velocities = sweepVelocities(sceneOf({}).sweep);
  return velocities;
}

const std::vector<double>& nearlyOneVelocity() {
  static const std::vector<double> velocities = logarithmic(kSlow, 1.35 * kSlow, 16);
  return velocities;
}

std::vector<double> figure4Forces() {
  return logarithmic(1e-3, 1e2, 20);
}

double forceForContact(const PreparedProfile& line, double fraction) {
  const SlidingConditions conditions{kModulus, kRelaxation, kSlow};
  double low = 0, high = 1e-9;
  const auto reaches = [&](double depth) {
    return slideAtDepth(line, conditions, depth).contactFraction >= fraction * (1 - 1e-12);
  };
  while (!reaches(high)) low = high, high *= 2;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (low + high);
    (reaches(middle) ? high : low) = middle;
  }
  const double force = slideAtDepth(line, conditions, high).normalForce;
  return fraction >= 1 ? 1.2 * force : force;
}

std::vector<SteadyResult> shippedResults(const PreparedProfile& line, double force,
                                         std::span<const double> velocities) {
  std::vector<SteadyResult> results(velocities.size());
  Load load;
  load.normalForce = force;
  slideSweep(line, {kModulus, kRelaxation, 0}, load, velocities, results);
  return results;
}

Tally shippedSweep(const PreparedProfile& line, double force, std::span<const double> velocities,
                   std::span<const SteadyResult> others) {
  static std::vector<SteadyResult> results;
  results.resize(velocities.size());
  Load load;
  load.normalForce = force;
  slideSweep(line, {kModulus, kRelaxation, 0}, load, velocities, results, {}, others);
  Tally tally{static_cast<double>(velocities.size())};
  for (const SteadyResult& result : results) count(result, tally);
  return tally;
}

Tally scalarSweep(const PreparedProfile& line, double force, std::span<const double> velocities) {
  Tally tally{static_cast<double>(velocities.size())};
  for (const double velocity : velocities)
    count(slideAtForce(line, {kModulus, kRelaxation, velocity}, force), tally);
  return tally;
}

void add(Tally& sum, const Tally& part) {
  sum.simulations += part.simulations;
  sum.passes += part.passes;
  sum.contactFraction += part.contactFraction;
}

}  // namespace asperity::bench
