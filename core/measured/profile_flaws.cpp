#include "core/measured/profile_flaws.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/base/linear_algebra.h"

namespace asperity {
namespace {

constexpr double kRoundingOfRange = 1e-6;  // of the range, as of numbers in single precision

/// Calls `take` with the difference of each two neighbours that were both measured.
template <class Take>
void forEachDifference(std::span<const double> heights, const Take& take) {
  for (std::size_t i = 1; i < heights.size(); ++i)
    if (!std::isnan(heights[i]) && !std::isnan(heights[i - 1])) take(heights[i] - heights[i - 1]);
}

/// The differences of neighbours: their number, their standard deviation and the smallest magnitude
/// of those that are more than rounding; and the range of the heights.
struct Differences {
  std::size_t count = 0;
  double spread = 0, smallest = HUGE_VAL, range = 0;
};

Differences differencesOf(std::span<const double> heights) {
  Differences found;
  double lowest = HUGE_VAL, highest = -HUGE_VAL;
  for (const double height : heights) {
    if (height < lowest) lowest = height;
    if (height > highest) highest = height;
  }
  found.range = highest - lowest;
  forEachDifference(heights, [&](double) { ++found.count; });
  double mean = 0, square = 0;
  forEachDifference(heights, [&](double difference) {
    mean += difference / static_cast<double>(found.count);
    square += difference * difference / static_cast<double>(found.count);
    const double size = std::abs(difference);
    if (size > kRoundingOfRange * found.range && size < found.smallest) found.smallest = size;
  });
  found.spread = std::sqrt(std::max(square - mean * mean, 0.0));
  return found;
}

/// The heights that occur, ascending; those that differ by rounding alone count once.
std::vector<double> levelsOf(std::vector<double> heights) {
  std::ranges::sort(heights);
  const double apart = kRoundingOfRange * (heights.back() - heights.front());
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
  const Differences found = differencesOf(heights);
  if (found.count == 0) return {};
  // The distance of two levels is at most the rounding above the difference of two heights of them,
  // and a common step is less than 1.5 times the smallest distance. Most profiles end here.
  constexpr double kLargest = 1.6;
  if (found.spread > kOfStep * kLargest * (found.smallest + kRoundingOfRange * found.range))
    return {};
  std::vector<double> known;
  for (const double height : heights)
    if (!std::isnan(height)) known.push_back(height);
  const std::vector<double> levels = levelsOf(std::move(known));
  if (levels.size() < kMinLevels) return {};
  const double step = commonStep(levels);
  if (!(step > 0) || found.spread > kOfStep * step) return {};
  std::vector<double> differences;
  forEachDifference(heights, [&](double difference) { differences.push_back(difference); });
  if (isExactShape(differences, step)) return {};
  return {step, static_cast<std::int64_t>(levels.size()), found.spread};
}

namespace {

/// A circle by its height, its slope and its curvature at x = 0.
using Circle = Eigen::Vector3d;

/// Returns the heights of a circle; nothing where some x lies beyond it. The form has no difference
/// of large numbers where the curvature is small.
std::optional<Eigen::VectorXd> heightsOf(const Circle& circle, const Eigen::VectorXd& x) {
  const double cosine = 1 / std::hypot(1.0, circle[1]), sine = circle[1] * cosine;
  const Eigen::ArrayXd turned = sine + circle[2] * x.array();
  constexpr double kSteepest = 0.999;
  if (!(turned.abs().maxCoeff() < kSteepest)) return {};
  return circle[0] + x.array() * (sine + turned) / (cosine + (1 - turned.square()).sqrt());
}

/// Fits a circle by the method of Gauss and Newton; `circle` is the start, which has
/// all x. Returns the rms of what
/// it leaves.
double fitCircle(Circle& circle, const Eigen::VectorXd& x, const Eigen::VectorXd& z) {
  constexpr int kIterations = 20, kHalvings = 12;
  constexpr double kStep = 1e-6, kConverged = 1e-6;
  double left = (z - *heightsOf(circle, x)).norm();
  for (int i = 0; i < kIterations; ++i) {
    const Eigen::VectorXd now = *heightsOf(circle, x);
    Eigen::MatrixXd slopes(x.size(), 3);
    for (int k = 0; k < 3; ++k) {
      Circle moved = circle;
      moved[k] += kStep;
      const auto heights = heightsOf(moved, x);
      if (!heights) return left / std::sqrt(static_cast<double>(x.size()));
      slopes.col(k) = (*heights - now) / kStep;
    }
    Circle step = LeastSquares(slopes).solve(z - now);
    const double before = left;
    for (int halving = 0; halving < kHalvings; ++halving, step /= 2)
      if (const auto heights = heightsOf(circle + step, x);
          heights && (z - *heights).norm() < left) {
        left = (z - *heights).norm();
        circle += step;
        break;
      }
    if (left > (1 - kConverged) * before) break;
  }
  return left / std::sqrt(static_cast<double>(x.size()));
}

}  // namespace

double radiusOfRoundForm(std::span<const double> heights, double spacing) {
  constexpr std::size_t kEnoughPoints = 2048;  // a form needs no more
  constexpr Eigen::Index kMinPoints = 16;
  constexpr double kClear = 0.8;
  const std::size_t stride = heights.size() / kEnoughPoints + 1;
  // Lengths are in halves of the profile, so that one step serves all unknowns.
  const double half = 0.5 * static_cast<double>(heights.size()) * spacing;
  std::vector<double> places, values;
  for (std::size_t i = 0; i < heights.size(); i += stride) {
    if (std::isnan(heights[i])) continue;
    places.push_back(static_cast<double>(i) * spacing / half - 1);
    values.push_back(heights[i] / half);
  }
  const Eigen::Map<const Eigen::VectorXd> x(places.data(), std::ssize(places)),
      z(values.data(), std::ssize(values));
  if (x.size() < kMinPoints) return 0;
  Eigen::MatrixXd powers(x.size(), 3);
  powers << Eigen::VectorXd::Ones(x.size()), x, x.array().square().matrix();
  const Eigen::Vector3d parabola = LeastSquares(powers).solve(z);
  const double byParabola =
      (z - powers * parabola).norm() / std::sqrt(static_cast<double>(x.size()));
  constexpr double kRounding = 1e-12;  // of the heights, where a parabola leaves nothing
  if (byParabola <= kRounding * z.lpNorm<Eigen::Infinity>()) return 0;
  const double steep = 1 + parabola[1] * parabola[1];
  Circle circle(parabola[0], parabola[1], 2 * parabola[2] / (steep * std::sqrt(steep)));
  // The parabola of a steep form is bent more than its circle, which would end before the profile.
  constexpr double kLess = 0.9;
  while (!heightsOf(circle, x)) circle.tail<2>() *= kLess;
  const double byCircle = fitCircle(circle, x, z);
  return byCircle < kClear * byParabola ? half / std::abs(circle[2]) : 0;
}

}  // namespace asperity
