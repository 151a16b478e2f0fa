#include "core/study/study_space.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/study/sobol_sequence.h"

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

double normalBelow(double x) {
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
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
    const double density = std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi);
    if (!(density > 0)) break;
    const double step = (normalBelow(x) - p) / density;
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
    return normalBelow(((isLog ? std::log(limit) : limit) - centre) / width);
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

}  // namespace asperity
