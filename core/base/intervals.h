// The interval that numbers cover, and their groups by equal intervals of the logarithm. Pure; any
// thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace asperity {

/// The smallest and the largest of the numbers that were added; empty at first.
struct Extent {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  /// Adds a number. One that is not finite changes nothing.
  void add(double value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  bool isEmpty() const { return !(least <= most); }
  /// Returns the distance between the ends; the extent must not be empty.
  double size() const { return most - least; }
};

inline Extent extentOf(std::span<const double> values) {
  Extent extent;
  for (const double value : values) extent.add(value);
  return extent;
}

/// Indices [begin, end) of values.
struct IndexRange {
  std::size_t begin = 0, end = 0;

  std::size_t size() const { return end - begin; }
};

/// Groups ascending values, all above 0, by equal intervals of their logarithm: interval k is from
/// 10^((k - shift) / perDecade) to the beginning of the next one. Empty intervals are left out.
inline std::vector<IndexRange> logBands(std::span<const double> ascending, double perDecade,
                                        double shift = 0) {
  std::vector<IndexRange> bands;
  double last = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    const double interval = std::floor(perDecade * std::log10(ascending[i]) + shift);
    if (bands.empty() || interval != last) bands.push_back({i, i});
    bands.back().end = i + 1;
    last = interval;
  }
  return bands;
}

}  // namespace asperity
