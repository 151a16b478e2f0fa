// Ticks of a logarithmic axis. Pure; any thread.
#pragma once

#include <string>
#include <vector>

namespace asperity {

struct LogTick {
  double decade = 0;  // decimal logarithm of the value
  std::string label;  // "10⁻³", "2×10³"
};

/// Ticks between the decimal logarithms `from` and `to`, ascending, at most `most`: decades,
/// thinned where they are many; where fewer than two fit, 2 and 5 times them, and then every whole
/// multiple. None where from >= to, either is not finite, or most < 1.
std::vector<LogTick> logTicks(double from, double to, int most);

/// Decimal logarithms of the places between the ticks: 2, 3, ..., 9 times every decade, or 2 and 5
/// times where `decadePixels` is below twelve times `apart`, or the decades alone where there is no
/// room for those. Ascending, none at a tick.
std::vector<double> minorLogTicks(double from, double to, const std::vector<LogTick>& ticks,
                                  double decadePixels, double apart);

}  // namespace asperity
