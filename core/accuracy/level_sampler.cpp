#include "core/accuracy/level_sampler.h"

#include <algorithm>
#include <numeric>

#include "core/base/processor_time.h"
#include "core/friction/realizations.h"

namespace asperity {
namespace {

/// The maximum number of nodes of the finest line in a run, and of x4, without which the error of a
/// line is unknown.
constexpr std::int64_t kMostNodes = std::int64_t{1} << 23;
constexpr std::int64_t kMostNodesOfThree = std::int64_t{1} << 25;

/// Realizations of different strata must be different lines; this is the distance of their numbers.
constexpr std::int64_t kApart = std::int64_t{1} << 32;

bool isAllowed(std::int64_t elements, int level) {
  const std::int64_t nodes = elements * levelOversampling(level);
  return level <= 1 || nodes <= (level == 2 ? kMostNodesOfThree : kMostNodes);
}

}  // namespace

LevelSampler::LevelSampler(const Scene& scene, const CurveOptions& options, const Profile* profile)
    : scene_(scene), options_(options), profile_(profile) {
  sources_.push_back(nullptr);
  for (int level = 1; level < kMostLevels; ++level)
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
  const RealizationTask task{scene_, source(level), {&one, 1}, first};
  results.clear();
  return slideRealizations(
      task, count, options_.threads, options_.stop,
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

}  // namespace asperity
