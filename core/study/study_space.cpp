#include "core/study/study_space.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/base/statistics.h"

namespace asperity {

namespace {

constexpr std::int64_t kMaxPoints = std::int64_t{1} << 62;

/// The finalizer of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): every bit of the result
/// depends on every bit of the argument.
std::uint64_t mixed(std::uint64_t bits) {
  bits += 0x9E3779B97F4A7C15U;
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9U;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBU;
  return bits ^ (bits >> 31);
}

/// Returns the random number that belongs to a seed, an axis and an index.
std::uint64_t randomBits(std::int64_t seed, std::size_t axis, std::uint64_t index) {
  return mixed(mixed(mixed(static_cast<std::uint64_t>(seed)) + axis) + index);
}

/// Returns a number between 0 and 1, neither of them.
double unitNumber(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

/// Returns the position of an index in a random permutation of 0 to count - 1: a Feistel network on
/// the next even number of bits, repeated until the result is in the range. It needs no memory.
std::uint64_t shuffled(std::uint64_t index, std::uint64_t count, std::int64_t seed,
                       std::size_t axis) {
  constexpr int kRounds = 4;
  if (count < 2) return index;
  const int half = (static_cast<int>(std::bit_width(count - 1)) + 1) / 2;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  const std::uint64_t key = randomBits(seed, axis, count);
  do {
    std::uint64_t left = index >> half, right = index & mask;
    for (int round = 0; round < kRounds; ++round) {
      const std::uint64_t other =
          left ^ (mixed(key + static_cast<std::uint64_t>(round) + (right << 8)) & mask);
      left = right;
      right = other;
    }
    index = left << half | right;
  } while (index >= count);
  return index;
}

/// Returns a Sobol coordinate with a random digital shift, which preserves the evenness of the
/// points and leaves none of them on the edge.
double shiftedSobol(std::int64_t index, std::size_t dimension, std::int64_t seed) {
  const auto shift = static_cast<std::uint32_t>(randomBits(seed, dimension, 0) >> 32);
  const std::uint32_t number =
      sobolNumber(static_cast<std::uint32_t>(index), static_cast<int>(dimension)) ^ shift;
  return (static_cast<double>(number) + 0.5) * 0x1p-32;
}

}  // namespace

double normalQuantile(double p) {
  if (p > 0.5) return -normalQuantile(1 - p);
  // The initial value is accurate to 4.5e-4 (Abramowitz and Stegun 26.2.23); Halley's method
  // refines it.
  const double t = std::sqrt(-2 * std::log(p));
  double x = -(t - (2.515517 + t * (0.802853 + t * 0.010328)) /
                       (1 + t * (1.432788 + t * (0.189269 + t * 0.001308))));
  for (int i = 0; i < 3; ++i) {
    const double density = normalDensity(x);
    if (!(density > 0)) break;
    const double step = (normalProbability(x) - p) / density;
    x -= step / (1 + x * step / 2);
  }
  return x;
}

double Distribution::quantile(double u) const {
  if (kind == DistributionKind::Uniform) {
    const bool hasLimits = std::isfinite(from) && std::isfinite(to);
    const double half = std::numbers::sqrt3 * deviation;
    const double low = hasLimits ? from : mean - half, high = hasLimits ? to : mean + half;
    return low + (high - low) * u;
  }
  const bool isLog = kind == DistributionKind::Lognormal;
  // These are the moments of the logarithm of a lognormal quantity.
  const double variance = isLog ? std::log1p(std::pow(deviation / mean, 2)) : deviation * deviation;
  const double centre = isLog ? std::log(mean) - variance / 2 : mean, width = std::sqrt(variance);
  const auto below = [&](double limit, double otherwise) {
    if (!std::isfinite(limit)) return otherwise;
    if (isLog && !(limit > 0)) return 0.0;
    return normalProbability(((isLog ? std::log(limit) : limit) - centre) / width);
  };
  const double least = below(from, 0), most = below(to, 1);
  const double part = std::clamp(least + (most - least) * u, 0x1p-1000, 1 - 0x1p-53);
  const double value = centre + width * normalQuantile(part);
  return std::clamp(isLog ? std::exp(value) : value, from, to);
}

std::int64_t StudyAxis::count() const {
  if (range || distribution) return 0;
  const StudyColumn& first = columns.front();
  return static_cast<std::int64_t>(std::max(first.numbers.size(), first.words.size()));
}

double StudyAxis::valueAt(double u, std::size_t column) const {
  const StudyColumn& one = columns[column];
  if (const std::int64_t values = count(); values > 0) {
    const auto index =
        std::min(static_cast<std::int64_t>(u * static_cast<double>(values)), values - 1);
    return one.hasWords() ? static_cast<double>(index)
                          : one.numbers[static_cast<std::size_t>(index)];
  }
  const bool isWhole = isWholeNumber(*one.row);
  if (distribution) {
    const double value = distribution->quantile(u);
    return isWhole ? std::round(value) : value;
  }
  const double low = range->from, high = range->to;
  if (range->isLogarithmic) {
    const double value = low * std::pow(high / low, u);
    return isWhole ? std::round(value) : value;
  }
  // Every whole number is equally likely.
  if (isWhole) return std::min(std::floor(low + u * (high - low + 1)), std::max(low, high));
  return low + (high - low) * u;
}

StudySpace::StudySpace(std::vector<StudyAxis> axes, Sampling sampling, std::int64_t samples,
                       std::int64_t seed)
    : axes_(std::move(axes)), sampling_(sampling), samples_(samples), seed_(seed) {
  for (const StudyAxis& axis : axes_) columns_ += axis.columns.size();
  if (sampling_ == Sampling::Grid) {
    for (const StudyAxis& axis : axes_)
      size_ = axis.count() > kMaxPoints / size_ ? kMaxPoints : size_ * axis.count();
    return;
  }
  size_ = samples_;
  if (sampling_ == Sampling::Saltelli) size_ *= static_cast<std::int64_t>(axes_.size()) + 2;
}

const StudyColumn& StudySpace::column(std::size_t number) const {
  for (const StudyAxis& axis : axes_) {
    if (number < axis.columns.size()) return axis.columns[number];
    number -= axis.columns.size();
  }
  return axes_.back().columns.back();
}

double StudySpace::coordinate(std::int64_t index, std::size_t axis) const {
  switch (sampling_) {
    case Sampling::Sobol:
      return shiftedSobol(index, axis, seed_);
    case Sampling::Saltelli: {
      const auto count = static_cast<std::int64_t>(axes_.size());
      const std::int64_t block = index / (count + 2), member = index % (count + 2);
      const bool isOfB = member == count + 1 || member == static_cast<std::int64_t>(axis) + 1;
      return shiftedSobol(block, isOfB ? axes_.size() + axis : axis, seed_);
    }
    default: {
      // Each of `samples` equal parts of the axis has one point, at a random position in it.
      const auto number = static_cast<std::uint64_t>(index);
      const auto count = static_cast<std::uint64_t>(samples_);
      const double part = static_cast<double>(shuffled(number, count, seed_, 2 * axis));
      const double u = (part + unitNumber(randomBits(seed_, 2 * axis + 1, number))) /
                       static_cast<double>(samples_);
      return std::min(u, 1 - 0x1p-53);
    }
  }
}

void StudySpace::pointInto(std::int64_t index, std::span<double> values) const {
  std::size_t first = columns_;
  for (std::size_t a = axes_.size(); a-- > 0;) {
    const StudyAxis& axis = axes_[a];
    double u = 0;
    std::int64_t number = 0;
    if (sampling_ == Sampling::Grid) {  // the last axis changes fastest
      number = index % axis.count();
      index /= axis.count();
    } else {
      u = coordinate(index, a);
    }
    first -= axis.columns.size();
    for (std::size_t c = 0; c < axis.columns.size(); ++c) {
      const StudyColumn& column = axis.columns[c];
      if (sampling_ != Sampling::Grid)
        values[first + c] = axis.valueAt(u, c);
      else
        values[first + c] = column.hasWords() ? static_cast<double>(number)
                                              : column.numbers[static_cast<std::size_t>(number)];
    }
  }
}

namespace {

constexpr int kBits = 32;
constexpr int kHighestDegree = 9;

/// A primitive polynomial over GF(2) and the first direction numbers that belong to it.
struct Dimension {
  int degree;
  std::uint32_t coefficients;  // of the polynomial, without the first and the last one
  std::uint32_t first[kHighestDegree];
};

/// The polynomials from the second dimension on; the first dimension is van der Corput's sequence.
/// From the table new-joe-kuo-6.21201 of S. Joe and F. Y. Kuo, SIAM J. Sci. Comput. 30, 2635
/// (2008), https://web.maths.unsw.edu.au/~fkuo/sobol/ (Copyright 2008 Frances Y. Kuo and Stephen
/// Joe, BSD licence).
constexpr Dimension kDimensions[kMaxSobolDimensions - 1] = {
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
    {7, 7, {1, 1, 3, 13, 7, 35, 63}},
    {7, 8, {1, 3, 5, 9, 1, 25, 53}},
    {7, 14, {1, 3, 1, 13, 9, 35, 107}},
    {7, 19, {1, 3, 1, 5, 27, 61, 31}},
    {7, 21, {1, 1, 5, 11, 19, 41, 61}},
    {7, 28, {1, 3, 5, 3, 3, 13, 69}},
    {7, 31, {1, 1, 7, 13, 1, 19, 1}},
    {7, 32, {1, 3, 7, 5, 13, 19, 59}},
    {7, 37, {1, 1, 3, 9, 25, 29, 41}},
    {7, 41, {1, 3, 5, 13, 23, 1, 55}},
    {7, 42, {1, 3, 7, 3, 13, 59, 17}},
    {7, 50, {1, 3, 1, 3, 5, 53, 69}},
    {7, 55, {1, 1, 5, 5, 23, 33, 13}},
    {7, 56, {1, 1, 7, 7, 1, 61, 123}},
    {7, 59, {1, 1, 7, 9, 13, 61, 49}},
    {7, 62, {1, 3, 3, 5, 3, 55, 33}},
    {8, 14, {1, 3, 1, 15, 31, 13, 49, 245}},
    {8, 21, {1, 3, 5, 15, 31, 59, 63, 97}},
    {8, 22, {1, 3, 1, 11, 11, 11, 77, 249}},
    {8, 38, {1, 3, 1, 11, 27, 43, 71, 9}},
    {8, 47, {1, 1, 7, 15, 21, 11, 81, 45}},
    {8, 49, {1, 3, 7, 3, 25, 31, 65, 79}},
    {8, 50, {1, 3, 1, 1, 19, 11, 3, 205}},
    {8, 52, {1, 1, 5, 9, 19, 21, 29, 157}},
    {8, 56, {1, 3, 7, 11, 1, 33, 89, 185}},
    {8, 67, {1, 3, 3, 3, 15, 9, 79, 71}},
    {8, 70, {1, 3, 7, 11, 15, 39, 119, 27}},
    {8, 84, {1, 1, 3, 1, 11, 31, 97, 225}},
    {8, 97, {1, 1, 1, 3, 23, 43, 57, 177}},
    {8, 103, {1, 3, 7, 7, 17, 17, 37, 71}},
    {8, 115, {1, 3, 1, 5, 27, 63, 123, 213}},
    {8, 122, {1, 1, 3, 5, 11, 43, 53, 133}},
    {9, 8, {1, 3, 5, 5, 29, 17, 47, 173, 479}},
    {9, 13, {1, 3, 3, 11, 3, 1, 109, 9, 69}},
    {9, 16, {1, 1, 1, 5, 17, 39, 23, 5, 343}},
    {9, 22, {1, 3, 1, 5, 25, 15, 31, 103, 499}},
    {9, 25, {1, 1, 1, 11, 11, 17, 63, 105, 183}},
    {9, 44, {1, 1, 5, 11, 9, 29, 97, 231, 363}},
    {9, 47, {1, 1, 5, 15, 19, 45, 41, 7, 383}},
    {9, 52, {1, 3, 7, 7, 31, 19, 83, 137, 221}},
    {9, 55, {1, 1, 1, 3, 23, 15, 111, 223, 83}},
    {9, 59, {1, 1, 5, 13, 31, 15, 55, 25, 161}},
    {9, 62, {1, 1, 3, 13, 25, 47, 39, 87, 257}},
};

using Directions = std::array<std::uint32_t, kBits>;

/// Returns the direction numbers v_j = m_j 2^(32 - j) of one dimension, by the recurrence of
/// Bratley and Fox, ACM Trans. Math. Softw. 14, 88 (1988).
Directions directionNumbers(int dimension) {
  Directions v{};
  if (dimension == 0) {
    for (int j = 0; j < kBits; ++j) v[static_cast<std::size_t>(j)] = 1U << (kBits - 1 - j);
    return v;
  }
  const Dimension& row = kDimensions[dimension - 1];
  for (int j = 0; j < kBits; ++j) {
    std::uint32_t& next = v[static_cast<std::size_t>(j)];
    if (j < row.degree) {
      next = row.first[j] << (kBits - 1 - j);
      continue;
    }
    const std::uint32_t before = v[static_cast<std::size_t>(j - row.degree)];
    next = before ^ (before >> row.degree);
    for (int k = 1; k < row.degree; ++k)
      if ((row.coefficients >> (row.degree - 1 - k) & 1U) != 0)
        next ^= v[static_cast<std::size_t>(j - k)];
  }
  return v;
}

const std::array<Directions, kMaxSobolDimensions>& allDirections() {
  static const auto all = [] {
    std::array<Directions, kMaxSobolDimensions> made{};
    for (int d = 0; d < kMaxSobolDimensions; ++d)
      made[static_cast<std::size_t>(d)] = directionNumbers(d);
    return made;
  }();
  return all;
}

}  // namespace

std::uint32_t sobolNumber(std::uint32_t index, int dimension) {
  const Directions& v = allDirections()[static_cast<std::size_t>(dimension)];
  std::uint32_t number = 0;
  // The Gray code of the index: neighbours differ in one direction number.
  for (std::uint32_t code = index ^ (index >> 1); code != 0; code &= code - 1)
    number ^= v[static_cast<std::size_t>(std::countr_zero(code))];
  return number;
}

}  // namespace asperity
