#include "core/friction/line_mean.h"

#include <algorithm>

namespace asperity {
namespace {

/// Returns sum_i (x_i - mean) (x_(i+k) - mean) / n.
double autocovariance(std::span<const double> deviations, std::size_t k) {
  double sum = 0;
  for (std::size_t i = 0; i + k < deviations.size(); ++i) sum += deviations[i] * deviations[i + k];
  return sum / static_cast<double>(deviations.size());
}

}  // namespace

MeanError meanErrorInOrder(std::span<const double> values) {
  RunningMean plain;
  for (const double value : values) plain.add(value);
  const auto n = static_cast<double>(values.size());
  const MeanError independent{plain.standardError(), std::max(0.0, n - 1)};
  if (values.size() < 3 || !(plain.variance() > 0)) return independent;
  std::vector<double> deviations(values.begin(), values.end());
  for (double& deviation : deviations) deviation -= plain.mean();
  const double variance = autocovariance(deviations, 0);
  const double next = autocovariance(deviations, 1);
  if (!(next > 2 * variance / std::sqrt(n))) return independent;
  // Two lags at a time; each lag k > 0 stands for -k, too.
  double sum = -variance, last = variance + next;
  std::size_t lags = 0;
  for (std::size_t k = 0; k + 1 < values.size(); k += 2) {
    const double pair =
        std::min(last, autocovariance(deviations, k) + autocovariance(deviations, k + 1));
    if (!(pair > 0)) break;
    sum += 2 * pair;
    last = pair;
    lags = k + 2;
  }
  const double width = 2 * static_cast<double>(lags) - 1;
  constexpr double kMostMissing = 0.5;  // where the rows are no longer than their correlation
  const double missing = std::min(width / n, kMostMissing);
  const double longer = std::max(1.0, sum / variance / (1 - missing));
  return {plain.standardError() * std::sqrt(longer), std::clamp(n / width, 1.0, n - 1)};
}

MeanError lineMeanError(std::span<const double> values, std::int64_t orderedRows) {
  LineMean mean(orderedRows);
  for (const double value : values) mean.add(value);
  return mean.error();
}

}  // namespace asperity
