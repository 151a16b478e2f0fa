// Ticks of a logarithmic axis. Pure; any thread.
#pragma once

#include <string>
#include <vector>

namespace asperity {

/// "10⁻³"; UTF-8.
std::string powerOfTen(int exponent);

struct LogTick {
  double decade = 0;  // decimal logarithm of the value
  std::string label;  // "10⁻³", "2×10³"
};

/// Ticks between the decimal logarithms `from` and `to`, ascending, at most `most`: decades,
/// thinned where they are many; where fewer than two fit, 2 and 5 times them, and then every whole
/// multiple. None where from >= to, either is not finite, or most < 1.
std::vector<LogTick> logTicks(double from, double to, int most);

}  // namespace asperity
