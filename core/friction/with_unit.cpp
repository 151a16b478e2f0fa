#include "core/friction/with_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity {

std::string withUnit(double value, std::string_view unit) {
  if (value == 0) return fmt::format("0 {}", unit);
  constexpr const char* prefixes[] = {"p", "n", "\u00B5", "m", "", "k", "M", "G", "T"};
  const int thousands =
      std::clamp(static_cast<int>(std::floor(std::log10(std::abs(value) * 1.0000001) / 3)), -4, 4);
  return fmt::format("{:.3g} {}{}", value * std::pow(1000.0, -thousands), prefixes[thousands + 4],
                     unit);
}

}  // namespace asperity
