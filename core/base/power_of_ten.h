// Powers of ten in front of units, as people write them: "10^-3 m/s", "\u00D710\u207B\u2076 m",
// "1e-3 mm". Pure functions; any thread.
#pragma once

#include <optional>
#include <string_view>

namespace asperity {

/// A power of ten in front of a unit.
struct PowerOfTen {
  double value = 1;
  int exponent = 0;
  bool isWritten = false;  // as a power, "10^-3"; otherwise as a number, "100"
};

/// Reads a power of ten: "1e-6", "100", "1/100", "10^-6", "\u00D710\u207B\u2076", "x10-6"; empty
/// where the text is none.
std::optional<PowerOfTen> powerOfTenIn(std::string_view text);

/// Returns whether a text is a power of ten that is written as such: "10^-3", "1e-3".
bool isWrittenPower(std::string_view text);

/// A unit and the power of ten in front of it.
struct ScaledUnit {
  PowerOfTen power{};
  std::string_view unit{};
};

/// Reads "1e-6 m", "10^-9*m", "x 10^3 Pa s". Empty where there is no power of ten in front.
std::optional<ScaledUnit> scaledUnit(std::string_view text);

}  // namespace asperity
