#include "core/friction/jackknife.h"

#include <algorithm>
#include <cmath>

#include "core/scene/plan.h"

namespace asperity {
namespace {

std::vector<LoadCase> makeCases(const std::vector<double>& normalForces,
                                const std::vector<double>& velocities) {
  std::vector<LoadCase> cases;
  for (const double force : normalForces) cases.push_back(atForce(force, velocities));
  return cases;
}

}  // namespace

GroupedMeans::GroupedMeans(const Scene& scene, const std::vector<double>& normalForces,
                           const std::vector<double>& velocities, const StateOptions& options)
    : GroupedMeans(scene, makeCases(normalForces, velocities), options) {}

GroupedMeans::GroupedMeans(const Scene& scene, std::vector<LoadCase> cases,
                           const StateOptions& options)
    : scene_(scene), cases_(std::move(cases)) {
  const LineSource source(scene_, curvePointsPerElement(scene_));
  line_ = source.statistics();
  slopesDiffer_ = source.slopesDiffer();
  length_ = source.length();
  realizations_ = source.lines();
  orderedRows_ = source.orderedRows();
  groups_ = static_cast<int>(
      std::min<std::int64_t>(kGroups, orderedRows_ > 0 ? orderedRows_ : realizations_));
  groupSizes_.assign(static_cast<std::size_t>(groups_), 0);
  sums_.assign(groupSizes_.size() * cellOf(cases_.size(), 0), Sums{});
  std::int64_t taken = 0;
  const RealizationPart part{scene_, cases_};
  const bool isWhole = slideRealizations(
      {source, {&part, 1}}, realizations_, options.threads, options.stop,
      [&](std::span<const SteadyResult> results) { add(taken++, results); },
      [&](std::int64_t done) {
        if (options.progress)
          options.progress(static_cast<double>(done) / static_cast<double>(realizations_));
      });
  if (!isWhole) throw StopRequested{};
}

void GroupedMeans::add(std::int64_t realization, std::span<const SteadyResult> results) {
  // Rows of a topography are alike where they are neighbours, so a group has neighbouring rows.
  const auto group = static_cast<std::size_t>(orderedRows_ > 0 ? realization % orderedRows_ *
                                                                     groups_ / orderedRows_
                                                               : realization % groups_);
  ++groupSizes_[group];
  Sums* const sums = sums_.data() + group * results.size();
  if (firstMu_.empty())
    for (const SteadyResult& result : results) firstMu_.push_back(result.mu);
  for (std::size_t k = 0; k < results.size(); ++k) {
    const SteadyResult& result = results[k];
    const double slope = std::isfinite(result.rmsSlopeContact) ? result.rmsSlopeContact : 0;
    const double above = result.mu - firstMu_[k];
    sums[k][Mu] += above;
    sums[k][MuSquared] += above * above;
    sums[k][NormalizedMu] += result.mu / result.rmsSlopeLine;
    sums[k][Contact] += result.contactFraction;
    sums[k][SlopeSquares] += result.contactFraction * slope * slope;
    sums[k][Indentation] += result.indentation;
    sums[k][Marginal] += result.marginalShare < 1 ? 1 : 0;
    largestResidual_ = std::max(largestResidual_, result.residual);
  }
}

std::size_t GroupedMeans::cellOf(std::size_t j, std::size_t i) const {
  return j * cases_.front().velocities.size() + i;
}

double GroupedMeans::mean(Quantity quantity, std::size_t j, std::size_t i, int leftOut) const {
  const std::size_t cell = cellOf(j, i), cells = cellOf(cases_.size(), 0);
  double sum = 0;
  std::int64_t count = 0;
  for (std::size_t group = 0; group < groupSizes_.size(); ++group) {
    if (static_cast<int>(group) == leftOut) continue;
    sum += sums_[group * cells + cell][quantity];
    count += groupSizes_[group];
  }
  return sum / static_cast<double>(count);
}

double GroupedMeans::mu(std::size_t j, std::size_t i, int leftOut) const {
  return firstMu_[cellOf(j, i)] + mean(Mu, j, i, leftOut);
}

double GroupedMeans::normalizedMu(std::size_t j, std::size_t i, int leftOut) const {
  return slopesDiffer_ ? mean(NormalizedMu, j, i, leftOut) : mu(j, i, leftOut) / line_.rmsSlope;
}

double GroupedMeans::contactFraction(std::size_t j, std::size_t i, int leftOut) const {
  return mean(Contact, j, i, leftOut);
}

double GroupedMeans::rmsSlopeContact(std::size_t j, std::size_t i, int leftOut) const {
  return std::sqrt(mean(SlopeSquares, j, i, leftOut) / mean(Contact, j, i, leftOut));
}

double GroupedMeans::muStandardError(std::size_t j, std::size_t i) const {
  if (realizations_ < 2) return kNotApplicable;
  if (orderedRows_ > 0)
    return jackknife(groups_, [&](int leftOut) { return mu(j, i, leftOut); }).standardError;
  const double above = mean(Mu, j, i, kAll);
  const double variance = std::max(0.0, mean(MuSquared, j, i, kAll) - above * above);
  return std::sqrt(variance / static_cast<double>(realizations_ - 1));
}

double GroupedMeans::marginalFraction(std::size_t j, std::size_t i) const {
  return mean(Marginal, j, i, kAll);
}

LawInput GroupedMeans::lawInput(std::size_t j, std::size_t i) const {
  return asperity::lawInput(elementLaw(scene_.elastomer), line_, length_, scene_.surface.hurst,
                            normalForce(j), velocities(j)[i]);
}

CurvePoint GroupedMeans::point(std::size_t j, std::size_t i) const {
  const LawInput in = lawInput(j, i);
  return {.velocity = velocities(j)[i],
          .mu = mu(j, i),
          .muStandardError = muStandardError(j, i),
          .muLaw = frictionLaw(in),
          .contactFraction = contactFraction(j, i),
          .rmsSlopeContact = rmsSlopeContact(j, i),
          .indentation = mean(Indentation, j, i, kAll),
          .normalizedMu = normalizedMu(j, i),
          .dimensionlessVelocity = dimensionlessVelocity(in),
          .dimensionlessForce = dimensionlessForce(in),
          .realizations = realizations_};
}

Estimate jackknife(int groups, const std::function<double(int leftOut)>& read,
                   std::int64_t orderedRows) {
  Estimate estimate;
  estimate.value = read(GroupedMeans::kAll);
  if (groups < 2) return estimate;
  std::vector<double> without;
  double sum = 0;
  for (int group = 0; group < groups; ++group) sum += without.emplace_back(read(group));
  if (orderedRows > 0) {
    std::vector<double> pseudo;
    for (const double value : without)
      pseudo.push_back(groups * estimate.value - (groups - 1) * value);
    estimate.standardError = lineMeanError(pseudo, orderedRows).standardError;
    return estimate;
  }
  double squares = 0;
  for (const double value : without) squares += (value - sum / groups) * (value - sum / groups);
  estimate.standardError = std::sqrt(squares * (groups - 1) / groups);
  return estimate;
}

}  // namespace asperity
