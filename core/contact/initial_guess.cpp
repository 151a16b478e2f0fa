#include "core/contact/initial_guess.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr std::size_t kCoarsest = 4;
constexpr double kHardly = 1e-3;  // less says that this line may well be in full contact

}  // namespace

std::size_t columnInOrder(std::size_t n, std::size_t count) {
  const std::size_t first = (count + kCoarsest - 1) / kCoarsest;
  if (n < first) return n * kCoarsest;
  n -= first;
  for (std::size_t stride = kCoarsest; stride > 1; stride /= 2) {
    const std::size_t half = stride / 2;
    const std::size_t here = count > half ? (count - half + stride - 1) / stride : 0;
    if (n < here) return half + n * stride;
    n -= here;
  }
  return count - 1;
}

/// ln(depth / depth at rest) of the other line: 0 at rest and in full contact, negative in between.
double InitialGuess::expected(std::size_t row, std::size_t column) const {
  if (others.empty()) return 0;
  const SteadyResult& other = others[row * velocities.size() + column];
  if (!(other.depthAtRest > 0)) return 0;
  const double sinking = std::log(other.indentation / other.depthAtRest);
  return sinking < -kHardly ? sinking : 0;
}

/// What this line has beyond that.
double InitialGuess::excess(std::size_t row, std::size_t column) const {
  return std::log(at(row, column).indentation / rests[row % kRests]) - expected(row, column);
}

/// The excess by Lagrange's polynomial in the logarithm of the force, through the rows before.
double InitialGuess::fromForces(std::size_t row, std::size_t column) const {
  constexpr std::size_t kMostRows = kRests - 1;
  std::size_t rows = 0;
  double x[kMostRows], y[kMostRows];
  while (rows < std::min(row, kMostRows) && isKnown(row - 1 - rows, column)) {
    x[rows] = std::log(forces[row - 1 - rows]);
    y[rows] = excess(row - 1 - rows, column);
    ++rows;
  }
  const double to = std::log(forces[row]);
  double sum = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    double share = y[i];
    for (std::size_t k = 0; k < rows; ++k)
      if (k != i) share *= (to - x[k]) / (x[i] - x[k]);
    sum += share;
  }
  return sum;
}

double InitialGuess::guess(std::size_t row, std::size_t column) const {
  const std::size_t count = velocities.size();
  std::size_t left = column, right = column;
  while (left > 0 && !isKnown(row, left - 1)) --left;
  while (right + 1 < count && !isKnown(row, right + 1)) ++right;
  const auto error = [&](std::size_t known) { return excess(row, known) - fromForces(row, known); };
  const bool hasLeft = left > 0, hasRight = right + 1 < count;
  double correction = 0;
  if (hasLeft && hasRight) {
    const double low = std::log(velocities[left - 1]), high = std::log(velocities[right + 1]);
    const double t = (std::log(velocities[column]) - low) / (high - low);
    correction = (1 - t) * error(left - 1) + t * error(right + 1);
  } else if (hasLeft || hasRight) {
    correction = error(hasLeft ? left - 1 : right + 1);
  }
  const double sinking = expected(row, column) + fromForces(row, column) + correction;
  return rests[row % kRests] * std::exp(std::min(sinking, 0.0));
}

}  // namespace asperity
