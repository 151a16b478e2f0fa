#include "core/base/range_text.h"

#include <fmt/format.h>

#include <string>

namespace asperity {
namespace {

/// "1e-06" and "1e+15" as "1e-6" and "1e15".
std::string withoutPadding(std::string number) {
  const std::size_t e = number.find('e');
  if (e == number.npos) return number;
  if (number[e + 1] == '+') number.erase(e + 1, 1);
  const std::size_t digits = e + (number[e + 1] == '-' ? 2 : 1);
  while (number[digits] == '0' && digits + 1 < number.size()) number.erase(digits, 1);
  return number;
}

}  // namespace

std::string plainNumber(double value) {
  return withoutPadding(fmt::format("{}", value));
}

PrintedNumber plain(double value) {
  return {plainNumber(value)};
}

Message rangeText(double minimum, double maximum, std::string_view unit) {
  const auto end = [](double value) {
    return PrintedNumber{withoutPadding(fmt::format("{:g}", value))};
  };
  if (unit.empty()) return message("{} to {}", end(minimum), end(maximum));
  return message("{} to {} {}", end(minimum), end(maximum), unit);
}

}  // namespace asperity
