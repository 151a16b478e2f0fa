// Numbers as text. Machine numbers (readNumber, plainNumber) are used in files and messages;
// printed numbers and quantities in pictures and in the window. The latter have one style
// everywhere, in English (a decimal point; ui/draw/ticks.h has them in the current language), in
// UTF-8 with a true minus, micro and multiplication sign. Pure; any thread.
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

#include "core/base/message.h"

namespace asperity {

/// The sign of printed negative numbers, in UTF-8.
inline constexpr std::string_view kMinusSign = "\u2212";

/// The digits of exponents, from 0 to 9.
inline constexpr std::array<std::string_view, 10> kRaisedDigits{
    "\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
    "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};

/// Whether significant digits keep trailing zeros ("0.0120") or not ("0.012").
enum class Zeros { Keep, Drop };

/// Returns "0.0123", "\u22121.5", "2.3\u00D710\u207B\u2075", "10\u207B\u2076"; "\u2013" for a
/// number that is not finite.
std::string printedNumber(double value, int digits = 3, Zeros zeros = Zeros::Drop);

/// Returns a power of ten, whatever its size: "2.3\u00D710\u2075", "10\u2075"; value finite, not 0.
std::string printedPower(double value, int digits = 3);

/// Returns a quantity with a prefix from f to P: "3.4 mN", "0 N". Metres, seconds and m/s have no
/// prefix above 1, kelvins none at all; outside the range of prefixes a power of ten precedes the
/// plain unit. Without a unit, it returns a pure number.
std::string printedQuantity(double value, std::string_view unit, int digits = 3,
                            Zeros zeros = Zeros::Drop);

/// Returns the same texts as values of a message, and a part of a whole in percent without the
/// sign.
inline PrintedNumber printed(double value, int digits = 3, Zeros zeros = Zeros::Drop) {
  return {printedNumber(value, digits, zeros)};
}
inline PrintedNumber printed(double value, std::string_view unit, int digits = 3,
                             Zeros zeros = Zeros::Drop) {
  return {printedQuantity(value, unit, digits, zeros)};
}
inline PrintedNumber printedPercent(double part, int digits = 3) {
  return printed(100 * part, digits);
}

/// Returns "10\u207B\u00B3".
std::string powerOfTen(int exponent);

/// Returns a number with this many decimals, with a true minus; never "-0".
std::string printedDecimals(double value, int decimals);

/// Returns a temperature as people read it: "20.0 \u00B0C".
Message celsius(double kelvin);

struct UnitPrefix {
  std::string_view text;  // "m"
  double size = 1;
};

/// Returns the prefix, from f to P, with which a magnitude is between 1 and 999.
UnitPrefix prefixFor(double magnitude);

/// Returns the nearest number with this many significant decimal digits.
double roundedToDigits(double value, int digits);

/// Returns text that reads back to the same number: "0.05", "-10000000", "1e-6"; exponents have no
/// padding.
std::string plainNumber(double value);

/// Returns the number as a cell of a table; empty where it is not finite.
std::string csvNumber(double value);

/// Returns the same as a value of a message.
PrintedNumber plain(double value);

/// Returns "0 to 1" or "1e-6 to 1e15 Pa": six digits, which suffice for every limit of the table.
Message rangeText(double minimum, double maximum, std::string_view unit = {});

/// Reads the whole text as a number that its type can hold; returns false where it contains
/// anything else.
template <class Number>
bool readNumber(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace asperity
