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
