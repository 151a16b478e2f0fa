#include "core/base/power_of_ten.h"

#include <cmath>
#include <string>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/text_number.h"

namespace asperity {

using namespace std::string_view_literals;

std::optional<PowerOfTen> powerOfTenIn(std::string_view text) {
  text = trimmedBlanks(text);
  const std::size_t whole = text.size();
  for (const std::string_view times : {"\u00D7"sv, "\u00B7"sv, "\u22C5"sv, "x"sv, "*"sv})
    if (text.starts_with(times)) text.remove_prefix(times.size());
  const bool hasTimes = text.size() < whole;
  text = trimmedBlanks(text);
  if (text.starts_with("1/")) {
    const auto divisor = powerOfTenIn(text.substr(2));
    if (!divisor) return {};
    return PowerOfTen{1 / divisor->value, -divisor->exponent};
  }
  double number = 0;
  if (readTextNumber(text, '.', number)) {
    if (!(number > 0)) return {};
    // Any other number is a length: "59.00 um" is no unit.
    const double exponent = std::log10(number);
    if (std::abs(exponent - std::round(exponent)) >= 1e-9) return {};
    return PowerOfTen{number, static_cast<int>(std::round(exponent)),
                      text.find_first_of("eE") != std::string_view::npos};
  }
  if (!text.starts_with("10")) return {};
  std::string exponent(text.substr(2));
  replaceAll(exponent, kMinusSign, "-");
  const std::string flat = exponent;
  for (const auto& [raised, plain] : {std::pair{"\u207B"sv, "-"sv}, {"^"sv, ""sv}})
    replaceAll(exponent, raised, plain);
  for (std::size_t digit = 0; digit < kRaisedDigits.size(); ++digit)
    replaceAll(exponent, kRaisedDigits[digit], std::to_string(digit));
  constexpr double kLargest = 30;
  if (!readTextNumber(exponent, '.', number) || std::abs(number) > kLargest) return {};
  // "10-3" without a sign of multiplication may be a range.
  return PowerOfTen{std::pow(10.0, number), static_cast<int>(number),
                    (hasTimes || exponent != flat) && number == std::round(number)};
}

bool isWrittenPower(std::string_view text) {
  const auto power = powerOfTenIn(text);
  return power && power->isWritten;
}

std::optional<ScaledUnit> scaledUnit(std::string_view text) {
  constexpr std::string_view kMarks = " *";
  for (std::size_t at = 0; (at = text.find_first_of(kMarks, at)) != std::string_view::npos; ++at)
    if (const auto power = powerOfTenIn(text.substr(0, at))) {
      const std::size_t unit = std::min(text.find_first_not_of(kMarks, at), text.size());
      return ScaledUnit{*power, text.substr(unit)};
    }
  return {};
}

}  // namespace asperity
