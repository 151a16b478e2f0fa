// The range that some numbers cover, such as the values that an axis must show. Pure; any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace asperity
