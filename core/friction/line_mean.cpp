#include "core/friction/line_mean.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

/// Returns sum_i (x_i - mean) (x_(i+k) - mean) / n.
double autocovariance(std::span<const double> deviations, std::size_t k) {
  double sum = 0;
  for (std::size_t i = 0; i + k < deviations.size(); ++i) sum += deviations[i] * deviations[i + k];
  return sum / static_cast<double>(deviations.size());
}

}  // namespace

MeanError errorOfCorrelatedMean(std::span<const double> values) {
  RunningMean plain;
  for (const double value : values) plain.add(value);
  const auto n = static_cast<double>(values.size());
  const MeanError independent{plain.standardError(), std::max(0.0, n - 1)};
  if (values.size() < 3 || !(plain.variance() > 0)) return independent;
  std::vector<double> deviations(values.begin(), values.end());
  for (double& deviation : deviations) deviation -= plain.mean();
  std::vector<double> known;  // c_0, c_1, ... as far as they are needed
  const auto c = [&](std::size_t k) {
    while (known.size() <= k) known.push_back(autocovariance(deviations, known.size()));
    return known[k];
  };
  if (!(c(1) > 2 * c(0) / std::sqrt(n))) return independent;
  constexpr int kMaxRounds = 20;
  constexpr double kSettled = 1e-3;
  double ofMean = 0;  // the variance of the mean, which each c_k lacks
  std::size_t lags = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    // Two lags at a time; each lag k > 0 stands for -k, too.
    double sum = -(c(0) + ofMean), last = std::numeric_limits<double>::infinity();
    lags = 0;
    for (std::size_t k = 0; k + 1 < values.size(); k += 2) {
      const double products = 2 * (n - static_cast<double>(k)) - 1;
      const double pair = std::min(last, c(k) + c(k + 1) + ofMean * products / n);
      if (!(pair > 0)) break;
      sum += 2 * pair;
      last = pair;
      lags = k + 2;
    }
    const double before = ofMean;
    // More than c_0 cannot be told from rows that are no longer than their correlation.
    ofMean = std::min(sum / n, c(0));
    if (std::abs(ofMean - before) <= kSettled * ofMean) break;
  }
  const double width = 2 * static_cast<double>(lags) - 1;
  return {std::max(plain.standardError(), std::sqrt(ofMean)), std::clamp(n / width, 1.0, n - 1)};
}

MeanError lineMeanError(std::span<const double> values, std::int64_t orderedRows) {
  LineMean mean(orderedRows);
  for (const double value : values) mean.add(value);
  return mean.error();
}

}  // namespace asperity
