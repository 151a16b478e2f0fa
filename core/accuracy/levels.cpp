#include "core/accuracy/levels.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/accuracy/pilot.h"
#include "core/base/jobs.h"
#include "core/base/statistics.h"
#include "core/base/stop.h"

namespace asperity {

namespace {

/// The maximum part of the error that comes from the resolution, so that the error of the finest
/// line is small against the interval.
constexpr double kResolutionShare = 0.3;

/// Lines that differ by at least this much may agree on average by chance.
constexpr double kChance = 0.25;

const LevelSums& sumsOf(const Halves& halves, std::size_t half, int level) {
  return halves[half][static_cast<std::size_t>(level)];
}

/// Returns the sums of both halves together.
RunningMean pooled(const Halves& halves, int level, RunningMean LevelSums::*part) {
  RunningMean mean = sumsOf(halves, 0, level).*part;
  mean.add(sumsOf(halves, 1, level).*part);
  return mean;
}

RunningMean LevelSums::*meanOn(int level, int first) {
  return level == first ? &LevelSums::direct : &LevelSums::correction;
}

/// Returns the friction on a level from one half, before or after lines were drawn for its mean.
double frictionOf(const Halves& halves, std::size_t half, int first, int last) {
  const LevelSums& lowest = sumsOf(halves, half, first);
  double mean = lowest.direct.count() > 0 ? lowest.direct.mean() : lowest.value.mean();
  for (int l = first + 1; l <= last; ++l) mean += sumsOf(halves, half, l).correction.mean();
  return mean;
}

/// Variance (from one half), cost and minimum number of lines on each level from `first` to `last`.
struct Terms {
  std::vector<double> variances, costs;
  std::vector<std::int64_t> fewest;
};

Terms termsOf(const Halves& halves, std::size_t half, int first, int last) {
  Terms terms;
  for (int l = first; l <= last; ++l) {
    const LevelSums& sums = sumsOf(halves, half, l);
    const double cost = pooled(halves, l, &LevelSums::operations).mean();
    if (l == first) {
      terms.variances.push_back(sums.value.variance());
      terms.costs.push_back(cost);
      terms.fewest.push_back(kMinDirect);
    } else {
      terms.variances.push_back(sums.correction.variance());
      terms.costs.push_back(cost + pooled(halves, l - 1, &LevelSums::operations).mean());
      terms.fewest.push_back(kMinCorrections);
    }
  }
  return terms;
}

/// Work for all lines of a plan, and for those that are still missing.
struct Work {
  double all = 0, missing = 0;
};

struct CostedPlan {
  LevelPlan plan;
  Work work;
};

CostedPlan planBetween(const Halves& halves, int first, int last, double relative,
                       double resolution) {
  LevelPlan plan{.first = first, .last = last, .resolutionError = resolution};
  Work work;
  for (const std::size_t half : {0U, 1U}) {
    const std::size_t other = 1 - half;
    const Terms terms = termsOf(halves, other, first, last);
    const double error = relative * std::abs(frictionOf(halves, other, first, last));
    // The mean of two means has half the variance of each. One half may give a smaller friction
    // than both together, by which the resolution is judged.
    const double allowed =
        2 * error *
        std::max(error - resolution * resolution / error, (1 - kResolutionShare) * error);
    plan.lines[half] = optimalLines(terms.variances, terms.costs, allowed, terms.fewest);
    for (int l = first; l <= last; ++l) {
      const auto k = static_cast<std::size_t>(l - first);
      const std::int64_t there = (sumsOf(halves, half, l).*meanOn(l, first)).count();
      const std::int64_t lines = plan.lines[half][k];
      work.all += static_cast<double>(lines) * terms.costs[k];
      work.missing +=
          static_cast<double>(std::max<std::int64_t>(0, lines - there)) * terms.costs[k];
    }
  }
  plan.operations = work.all;
  return {plan, work};
}

}  // namespace

std::vector<std::int64_t> optimalLines(std::span<const double> variances,
                                       std::span<const double> costs, double allowed,
                                       std::span<const std::int64_t> fewest) {
  double sum = 0;
  for (std::size_t k = 0; k < variances.size(); ++k) sum += std::sqrt(variances[k] * costs[k]);
  std::vector<std::int64_t> lines;
  for (std::size_t k = 0; k < variances.size(); ++k) {
    const double wanted = std::ceil(std::sqrt(variances[k] / costs[k]) * sum / allowed);
    // This is more than any run can do, but still finite.
    lines.push_back(std::max(fewest[k], static_cast<std::int64_t>(std::min(wanted, 1e15))));
  }
  return lines;
}

double estimateResolutionError(const Halves& halves, int level) {
  const RunningMean last = pooled(halves, level, &LevelSums::correction);
  const double byChance = kChance * std::sqrt(last.variance());
  return std::max(std::abs(last.mean()), byChance) / 3;
}

double lineError(std::span<const double> friction) {
  const std::size_t l = friction.size() - 1;
  const double last = std::abs(friction[l] - friction[l - 1]);
  const double before = std::abs(friction[l - 1] - friction[l - 2]);
  return std::max(last, before / 4);
}

std::optional<LevelPlan> planLevels(const Halves& halves, int known, double relative) {
  std::optional<CostedPlan> best;
  for (int last = 1; last < known; ++last) {
    const double resolution = estimateResolutionError(halves, last);
    const double mu = (frictionOf(halves, 0, 0, last) + frictionOf(halves, 1, 0, last)) / 2;
    if (!(resolution < kResolutionShare * relative * std::abs(mu))) continue;
    std::optional<CostedPlan> ofLevel;
    for (int first = 0; first <= last; ++first) {
      const CostedPlan costed = planBetween(halves, first, last, relative, resolution);
      if (!ofLevel || costed.work.missing < ofLevel->work.missing) ofLevel = costed;
      if (first == last) ofLevel->plan.plainOperations = costed.work.all;
    }
    if (!best || ofLevel->work.missing < best->work.missing) best = ofLevel;
  }
  if (!best) return {};
  return best->plan;
}

LevelEstimate estimateMean(const Halves& halves, const LevelPlan& plan) {
  LevelEstimate estimate;
  double squares = 0, spread = 0;
  for (const std::size_t half : {0U, 1U})
    for (int l = plan.first; l <= plan.last; ++l) {
      const RunningMean& mean = sumsOf(halves, half, l).*meanOn(l, plan.first);
      estimate.mean += 0.5 * mean.mean();
      const double part = 0.25 * mean.variance() / static_cast<double>(mean.count());
      squares += part;
      spread += part * part / static_cast<double>(mean.count() - 1);
    }
  estimate.standardError = std::sqrt(squares);
  estimate.degreesOfFreedom = spread > 0 ? squares * squares / spread : 1e9;
  return estimate;
}

double excessVariance(const Halves& halves, const LevelPlan& plan, double relative) {
  const LevelEstimate estimate = estimateMean(halves, plan);
  const double error = relative * std::abs(estimate.mean);
  const double random = estimate.standardError / error, resolution = plan.resolutionError / error;
  return random * random / (1 - resolution * resolution);
}

namespace {

/// The maximum number of nodes of the finest line in a run, and of x4, without which the error of a
/// line is unknown.
constexpr std::int64_t kMaxNodes = std::int64_t{1} << 23;
constexpr std::int64_t kMaxNodesOfThree = std::int64_t{1} << 25;

/// Realizations of different strata must be different lines; this is the distance of their numbers.
constexpr std::int64_t kApart = std::int64_t{1} << 32;

bool isAllowed(std::int64_t elements, int level) {
  const std::int64_t nodes = elements * levelOversampling(level);
  return level <= 1 || nodes <= (level == 2 ? kMaxNodesOfThree : kMaxNodes);
}

}  // namespace

LevelSampler::LevelSampler(const Scene& scene, const CurveOptions& options, const Profile* profile)
    : scene_(scene), options_(options), profile_(profile) {
  sources_.push_back(nullptr);
  for (int level = 1; level < kMaxLevels; ++level)
    if (isAllowed(source(0).elements(), level)) sources_.push_back(nullptr);
}

const LineSource& LevelSampler::source(int level) {
  auto& source = sources_[static_cast<std::size_t>(level)];
  if (source) return *source;
  const double begin = threadSeconds();
  source = std::make_unique<LineSource>(scene_, levelOversampling(level), profile_);
  secondsOfSources_ += threadSeconds() - begin;
  return *source;
}

bool LevelSampler::slide(int level, const States& states, std::int64_t first, std::int64_t count,
                         std::vector<std::vector<SteadyResult>>& results) {
  LoadCase one{scene_.load, {}};
  for (const VelocityState* state : states) one.velocities.push_back(state->velocity);
  const RealizationPart part{scene_, {&one, 1}};
  results.clear();
  return slideRealizations(
      {source(level), {&part, 1}, first}, count, options_.threads, options_.stop,
      [&](std::span<const SteadyResult> row) { results.emplace_back(row.begin(), row.end()); });
}

double LevelSampler::count(const SteadyResult& result, int level) {
  const double nodes = static_cast<double>(source(level).elements() * levelOversampling(level));
  const double operations = static_cast<double>(result.passes) * nodes;
  cost_.operations += operations;
  cost_.passes += result.passes;
  ++cost_.solves;
  cost_.largestResidual = std::max(cost_.largestResidual, result.residual);
  return operations;
}

void LevelSampler::add(LevelSums& sums, const SteadyResult& result, int level) {
  sums.operations.add(count(result, level));
  sums.value.add(result.mu);
}

std::int64_t LevelSampler::lines() const {
  return std::accumulate(done_.begin(), done_.end(), std::int64_t{0});
}

bool LevelSampler::sample(const Stratum& stratum, const States& states, std::int64_t lines) {
  const auto& [level, isDirect, half] = stratum;
  const std::int64_t number = 4 * level + (isDirect ? 0 : 2) + static_cast<std::int64_t>(half);
  std::int64_t& done = done_[static_cast<std::size_t>(number)];
  const std::int64_t first = number * kApart + done;
  done += lines;
  std::vector<std::vector<SteadyResult>> coarse, fine;
  if (!isDirect && !slide(level - 1, states, first, lines, coarse)) return false;
  if (!slide(level, states, first, lines, fine)) return false;
  for (std::size_t r = 0; r < fine.size(); ++r)
    for (std::size_t i = 0; i < states.size(); ++i) {
      LevelSums& sums = states[i]->sums(half, level);
      add(sums, fine[r][i], level);
      states[i]->facts.add(fine[r][i]);
      if (isDirect) {
        sums.direct.add(fine[r][i].mu);
      } else {
        add(states[i]->sums(half, level - 1), coarse[r][i], level - 1);
        sums.correction.add(fine[r][i].mu - coarse[r][i].mu);
      }
    }
  return true;
}

namespace {

/// The rows of a topography as its coarsest lines.
struct RowsAsLines {
  Scene scene;
  LineSource source;
  LoadCase sweep;

  RowsAsLines(const Scene& given, const std::vector<double>& velocities)
      : scene(withEveryRow(given)), source(scene, 1), sweep{given.load, velocities} {}

  static Scene withEveryRow(Scene scene) {
    scene.accuracy = {Scheme::Cubic, 1, 0};
    scene.ensemble.realizations = 0;
    return scene;
  }

  /// Slides `count` rows from the first; as slideRealizations.
  bool slide(std::int64_t first, std::int64_t count, int threads, const std::stop_token& stop,
             const TakeRealization& take) const {
    const RealizationPart part{scene, {&sweep, 1}};
    return slideRealizations({source, {&part, 1}, first}, count, threads, stop, take);
  }
};

}  // namespace

std::vector<MeanError> errorsOfRows(const Scene& scene, const std::vector<double>& velocities,
                                    int threads, const std::stop_token& stop) {
  const RowsAsLines rows(scene, velocities);
  std::vector<LineMean> means(velocities.size(), LineMean(rows.source.rows()));
  const auto take = [&](std::span<const SteadyResult> results) {
    for (std::size_t i = 0; i < results.size(); ++i) means[i].add(results[i].mu);
  };
  if (!rows.slide(0, rows.source.rows(), threads, stop, take)) return {};
  std::vector<MeanError> errors;
  for (const LineMean& mean : means) {
    errors.push_back(mean.error());
    errors.back().standardError /= std::abs(mean.mean());
  }
  return errors;
}

PredictedRowErrors predictErrorsOfRows(const Scene& scene, const std::vector<double>& velocities,
                                       const std::stop_token& stop) {
  constexpr std::int64_t kRows = 32;
  const RowsAsLines rows(scene, velocities);
  const double start = threadSeconds();
  const std::int64_t count = std::min(kRows, rows.source.rows());
  std::vector<std::vector<double>> mu(velocities.size());
  const auto take = [&](std::span<const SteadyResult> results) {
    for (std::size_t i = 0; i < results.size(); ++i) mu[i].push_back(results[i].mu);
  };
  for (const std::int64_t row : sampledLines(rows.source, count))
    if (!rows.slide(row, 1, 1, stop, take)) throw StopRequested{};
  const auto all = static_cast<double>(rows.source.rows());
  PredictedRowErrors predicted;
  for (const std::vector<double>& each : mu)
    predicted.standardErrors.push_back(std::sqrt(varianceOfMean(each, rows.source, all)) /
                                       std::abs(mean(each)));
  predicted.seconds = (threadSeconds() - start) * all / static_cast<double>(count);
  return predicted;
}

}  // namespace asperity
