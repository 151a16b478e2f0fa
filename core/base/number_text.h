// Numbers as text. Machine numbers (readNumber, plainNumber) stand in files and messages; printed
// numbers and quantities stand in pictures and in the window: one style everywhere, in English (a
// decimal point; ui/draw/ticks.h has them in the language in use), UTF-8 with a true minus, micro
// and multiplication sign. Pure; any thread.
#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

#include "core/base/message.h"

namespace asperity {

/// Significant digits kept as they are ("0.0120") or without trailing zeros ("0.012").
enum class Zeros { Keep, Drop };

/// "0.0123", "\u22121.5", "2.3\u00D710\u207B\u2075", "10\u207B\u2076"; "\u2013" where it is not a
/// finite number.
std::string printedNumber(double value, int digits = 3, Zeros zeros = Zeros::Drop);

/// As a power of ten, whatever its size: "2.3\u00D710\u2075", "10\u2075"; value finite, not 0.
std::string printedPower(double value, int digits = 3);

/// With a prefix from f to P: "3.4 mN", "0 N". Metres, seconds and m/s have none above 1, kelvins
/// none at all; beyond the prefixes a power of ten stands before the plain unit. A pure number
/// where there is no unit.
std::string printedQuantity(double value, std::string_view unit, int digits = 3,
                            Zeros zeros = Zeros::Drop);

/// "10\u207B\u00B3".
std::string powerOfTen(int exponent);

/// So many decimals, with a true minus; never "-0".
std::string printedDecimals(double value, int decimals);

struct UnitPrefix {
  std::string_view text;  // "m"
  double size = 1;
};

/// The prefix that leaves 1 to 999 of a magnitude, from f to P.
UnitPrefix prefixFor(double magnitude);

/// Reads back to the same number: "0.05", "-10000000", "1e-6"; the exponent without padding.
std::string plainNumber(double value);

/// The same as a value of a message.
PrintedNumber plain(double value);

/// "0 to 1", "1e-6 to 1e15 Pa": six digits, which every limit of the table has.
Message rangeText(double minimum, double maximum, std::string_view unit = {});

/// All of the text as a number that its type can hold; false where there is more or less.
template <class Number>
bool readNumber(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace asperity
