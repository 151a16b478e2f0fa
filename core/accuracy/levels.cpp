#include "core/accuracy/levels.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

/// At most this part of the error is left to the resolution.
constexpr double kResolutionShare = 0.5;
constexpr std::int64_t kFewestLines = 8;

/// Variance and cost of one line of each level of a plan, from `first` to `last`.
struct Terms {
  std::vector<double> variances, costs;
};

Terms termsOf(std::span<const LevelSums> levels, int first, int last) {
  Terms terms;
  for (int l = first; l <= last; ++l) {
    const LevelSums& here = levels[static_cast<std::size_t>(l)];
    if (l == first) {
      terms.variances.push_back(here.value.variance());
      terms.costs.push_back(here.operations.mean());
    } else {
      const LevelSums& below = levels[static_cast<std::size_t>(l - 1)];
      terms.variances.push_back(here.correction.variance());
      terms.costs.push_back(here.operations.mean() + below.operations.mean());
    }
  }
  return terms;
}

double operationsOf(const Terms& terms, const std::vector<std::int64_t>& lines) {
  double sum = 0;
  for (std::size_t k = 0; k < lines.size(); ++k)
    sum += static_cast<double>(lines[k]) * terms.costs[k];
  return sum;
}

const RunningMean& meanOf(std::span<const LevelSums> levels, const LevelPlan& plan, int level) {
  const LevelSums& sums = levels[static_cast<std::size_t>(level)];
  return level == plan.first ? sums.direct : sums.correction;
}

}  // namespace

std::vector<std::int64_t> optimalLines(std::span<const double> variances,
                                       std::span<const double> costs, double allowed,
                                       std::int64_t fewest) {
  double sum = 0;
  for (std::size_t k = 0; k < variances.size(); ++k) sum += std::sqrt(variances[k] * costs[k]);
  std::vector<std::int64_t> lines;
  for (std::size_t k = 0; k < variances.size(); ++k) {
    const double wanted = std::ceil(std::sqrt(variances[k] / costs[k]) * sum / allowed);
    // Beyond any run, but still a number.
    lines.push_back(std::max(fewest, static_cast<std::int64_t>(std::min(wanted, 1e15))));
  }
  return lines;
}

std::optional<double> resolutionErrorOf(std::span<const LevelSums> levels, int level) {
  const auto above = static_cast<std::size_t>(level + 1);
  if (above >= levels.size() || levels[above].correction.count() == 0) return {};
  return 4.0 / 3.0 * std::abs(levels[above].correction.mean());
}

std::optional<LevelPlan> planLevels(std::span<const LevelSums> levels, int known, double error) {
  int last = 0;
  while (last + 1 < known) {
    const std::optional<double> resolution = resolutionErrorOf(levels, last);
    if (resolution && *resolution <= kResolutionShare * error) break;
    ++last;
  }
  const std::optional<double> resolution = resolutionErrorOf(levels, last);
  if (!resolution) return {};
  const double allowed = error * error - *resolution * *resolution;
  std::optional<LevelPlan> best;
  for (int first = 0; first <= last; ++first) {
    const Terms terms = termsOf(levels, first, last);
    LevelPlan plan{first, last, optimalLines(terms.variances, terms.costs, allowed, kFewestLines),
                   0,     0,    *resolution};
    plan.operations = operationsOf(terms, plan.lines);
    if (!best || plan.operations < best->operations) best = plan;
    if (first == last) best->plainOperations = plan.operations;
  }
  return best;
}

LevelEstimate estimateOf(std::span<const LevelSums> levels, const LevelPlan& plan) {
  LevelEstimate estimate;
  double squares = 0, spread = 0;
  for (int l = plan.first; l <= plan.last; ++l) {
    const RunningMean& mean = meanOf(levels, plan, l);
    estimate.mean += mean.mean();
    const double part = mean.variance() / static_cast<double>(mean.count());
    squares += part;
    spread += part * part / static_cast<double>(mean.count() - 1);
  }
  estimate.standardError = std::sqrt(squares);
  estimate.freedom = spread > 0 ? squares * squares / spread : 1e9;
  return estimate;
}

double studentQuantile(double freedom) {
  constexpr double z = 1.959963984540054;
  constexpr double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * freedom) + (5 * z5 + 16 * z3 + 3 * z) / (96 * freedom * freedom) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * freedom * freedom * freedom);
}

}  // namespace asperity
