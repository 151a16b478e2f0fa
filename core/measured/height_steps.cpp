#include "core/measured/height_steps.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace asperity {
namespace {

/// The heights that occur, ascending; those that differ by rounding alone count once.
std::vector<double> levelsOf(std::vector<double> heights) {
  constexpr double kRounding = 1e-6;  // of the range, as of numbers in single precision
  std::ranges::sort(heights);
  const double apart = kRounding * (heights.back() - heights.front());
  std::vector<double> levels{heights.front()};
  for (const double height : heights)
    if (height - levels.back() > apart) levels.push_back(height);
  return levels;
}

/// Returns the distance of which all levels are multiples; 0 where there is none.
double commonStep(const std::vector<double>& levels) {
  constexpr double kAllowed = 0.05;  // of a step
  double smallest = levels.back() - levels.front();
  for (std::size_t i = 1; i < levels.size(); ++i)
    smallest = std::min(smallest, levels[i] - levels[i - 1]);
  const double range = levels.back() - levels.front();
  const double step = range / std::round(range / smallest);
  const bool areMultiples = std::ranges::all_of(levels, [&](double level) {
    const double multiple = (level - levels.front()) / step;
    return std::abs(multiple - std::round(multiple)) < kAllowed;
  });
  return areMultiples ? step : 0;
}

/// Returns whether a profile consists of a few kinds of straight parts: kinds differ in slope or
/// length.
bool isExactShape(std::span<const double> differences, double step) {
  constexpr std::size_t kManyKinds = 8;
  std::set<std::pair<long, std::size_t>> kinds;
  for (std::size_t first = 0, end = 0; first < differences.size(); first = end) {
    const long rise = std::lround(differences[first] / step);
    while (end < differences.size() && std::lround(differences[end] / step) == rise) ++end;
    kinds.emplace(rise, end - first);
  }
  return kinds.size() < kManyKinds;
}

}  // namespace

HeightSteps coarseSteps(std::span<const double> heights) {
  constexpr double kOfStep = 1.4;
  constexpr std::size_t kMinLevels = 4;
  std::vector<double> known, differences;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (std::isnan(heights[i])) continue;
    known.push_back(heights[i]);
    if (i > 0 && !std::isnan(heights[i - 1])) differences.push_back(heights[i] - heights[i - 1]);
  }
  if (differences.empty()) return {};
  double mean = 0, square = 0;
  for (const double difference : differences) {
    mean += difference / static_cast<double>(differences.size());
    square += difference * difference / static_cast<double>(differences.size());
  }
  const double spread = std::sqrt(std::max(square - mean * mean, 0.0));
  const std::vector<double> levels = levelsOf(std::move(known));
  if (levels.size() < kMinLevels) return {};
  const double step = commonStep(levels);
  if (!(step > 0) || spread > kOfStep * step || isExactShape(differences, step)) return {};
  return {step, static_cast<std::int64_t>(levels.size()), spread};
}

}  // namespace asperity
