#include "ui/picture/log_ticks.h"

#include <cmath>

namespace asperity {

std::string powerOfTen(int exponent) {
  static constexpr const char* kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = "10";
  if (exponent < 0) text += "⁻";
  for (const char digit : std::to_string(std::abs(exponent))) text += kRaised[digit - '0'];
  return text;
}

std::vector<int> decades(double from, double to, int most) {
  std::vector<int> exponents;
  if (!(from > 0) || !(to > from) || most < 1) return exponents;
  const int first = static_cast<int>(std::ceil(std::log10(from) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(to) + 1e-9));
  int step = 1;
  while ((last - first) / step + 1 > most) ++step;
  for (int exponent = first; exponent <= last; ++exponent)
    if (exponent % step == 0) exponents.push_back(exponent);
  return exponents;
}

}  // namespace asperity
