#include "core/accuracy/level_sampler.h"

#include <algorithm>

#include "core/friction/realizations.h"

namespace asperity {
namespace {

/// Nodes of the finest line that a run may make.
constexpr std::int64_t kMostNodes = std::int64_t{1} << 23;

/// Realizations of different levels and purposes must be different lines.
constexpr std::int64_t kApart = std::int64_t{1} << 32;

}  // namespace

LevelSampler::LevelSampler(const Scene& scene, const CurveOptions& options)
    : scene_(scene), options_(options) {
  sources_.push_back(std::make_unique<LineSource>(scene_, 1));
  for (int level = 1; level < kMostLevels; ++level)
    if (level <= 1 || source(0).elements() * oversamplingOf(level) <= kMostNodes)
      sources_.push_back(nullptr);
}

const LineSource& LevelSampler::source(int level) {
  auto& source = sources_[static_cast<std::size_t>(level)];
  if (!source) source = std::make_unique<LineSource>(scene_, oversamplingOf(level));
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

void LevelSampler::count(LevelSums& sums, const SteadyResult& result, int level) {
  const double nodes = static_cast<double>(source(level).elements() * oversamplingOf(level));
  const double operations = static_cast<double>(result.passes) * nodes;
  sums.operations.add(operations);
  sums.value.add(result.mu);
  cost_.operations += operations;
  cost_.passes += result.passes;
  ++cost_.solves;
  cost_.largestResidual = std::max(cost_.largestResidual, result.residual);
}

bool LevelSampler::sampleDirect(int level, const States& states, std::int64_t lines) {
  const auto place = static_cast<std::size_t>(level);
  const std::int64_t first = 2 * level * kApart + directDone_[place];
  directDone_[place] += lines;
  std::vector<std::vector<SteadyResult>> results;
  if (!slide(level, states, first, lines, results)) return false;
  for (const auto& row : results)
    for (std::size_t i = 0; i < states.size(); ++i) {
      LevelSums& sums = states[i]->levels[place];
      count(sums, row[i], level);
      sums.direct.add(row[i].mu);
      states[i]->facts.add(row[i]);
    }
  return true;
}

bool LevelSampler::sampleCorrection(int level, const States& states, std::int64_t lines) {
  const auto place = static_cast<std::size_t>(level);
  const std::int64_t first = (2 * level + 1) * kApart + correctionDone_[place];
  correctionDone_[place] += lines;
  std::vector<std::vector<SteadyResult>> coarse, fine;
  if (!slide(level - 1, states, first, lines, coarse)) return false;
  if (!slide(level, states, first, lines, fine)) return false;
  for (std::size_t r = 0; r < fine.size(); ++r)
    for (std::size_t i = 0; i < states.size(); ++i) {
      LevelSums& sums = states[i]->levels[place];
      count(states[i]->levels[place - 1], coarse[r][i], level - 1);
      count(sums, fine[r][i], level);
      sums.correction.add(fine[r][i].mu - coarse[r][i].mu);
      states[i]->facts.add(fine[r][i]);
    }
  return true;
}

}  // namespace asperity
