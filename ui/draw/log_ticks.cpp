#include "ui/draw/log_ticks.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"

namespace asperity {
namespace {

constexpr double kRounding = 1e-9;    // of a decade: a tick at the very end belongs to the axis
constexpr double kMostDecades = 700;  // a double holds no more

/// The multiples of every decade inside [from, to].
std::vector<LogTick> multiples(double from, double to, const std::vector<int>& factors) {
  std::vector<LogTick> ticks;
  const int last = static_cast<int>(std::floor(to + kRounding));
  for (int exponent = static_cast<int>(std::floor(from)); exponent <= last; ++exponent)
    for (const int factor : factors) {
      const double decade = exponent + std::log10(factor);
      if (decade < from - kRounding || decade > to + kRounding) continue;
      const std::string power = powerOfTen(exponent);
      ticks.push_back({decade, factor == 1 ? power : std::to_string(factor) + "×" + power});
    }
  return ticks;
}

std::vector<LogTick> decades(double from, double to, int most) {
  std::vector<LogTick> ticks;
  const int first = static_cast<int>(std::ceil(from - kRounding));
  const int last = static_cast<int>(std::floor(to + kRounding));
  int step = 1;  // the multiples of it are the ticks
  const auto count = [&] {
    return std::floor(static_cast<double>(last) / step) -
           std::ceil(static_cast<double>(first) / step) + 1;
  };
  while (count() > most) ++step;
  for (int exponent = first; exponent <= last; ++exponent)
    if (exponent % step == 0)
      ticks.push_back({static_cast<double>(exponent), powerOfTen(exponent)});
  return ticks;
}

}  // namespace

std::vector<LogTick> logTicks(double from, double to, int most) {
  if (!(from < to) || !(std::abs(from) < kMostDecades) || !(std::abs(to) < kMostDecades) ||
      most < 1)
    return {};
  std::vector<LogTick> ticks = decades(from, to, most);
  if (ticks.size() > 1 || to - from > 2) return ticks;
  for (const std::vector<int>& factors : {std::vector{1, 2, 5}, {1, 2, 3, 4, 5, 6, 7, 8, 9}}) {
    std::vector<LogTick> finer = multiples(from, to, factors);
    if (ticks.size() > 1 || static_cast<int>(finer.size()) > most) break;
    ticks = std::move(finer);
  }
  return ticks;
}

std::vector<double> minorLogTicks(double from, double to, const std::vector<LogTick>& ticks,
                                  double decadePixels, double apart) {
  std::vector<double> minor;
  if (!(from < to) || !(std::abs(from) < kMostDecades) || !(std::abs(to) < kMostDecades))
    return minor;
  std::vector<int> factors{1};
  if (decadePixels >= 12 * apart)
    factors = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  else if (decadePixels >= 5 * apart)
    factors = {1, 2, 5};
  else if (decadePixels < apart)
    return minor;
  for (const LogTick& place : multiples(from, to, factors))
    if (std::none_of(ticks.begin(), ticks.end(), [&](const LogTick& tick) {
          return std::abs(tick.decade - place.decade) < kRounding;
        }))
      minor.push_back(place.decade);
  return minor;
}

}  // namespace asperity
