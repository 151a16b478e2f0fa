// The units that text files contain, in whatever spelling: whether a word is one, and units of
// length and their powers. Pure; any thread.
#pragma once

#include <optional>
#include <string_view>

namespace asperity {

/// Returns whether the word is a unit of length, time, frequency, temperature, force, pressure,
/// velocity, angle or a share. "-" and "1" stand for a pure number.
bool isUnitWord(std::string_view text);

/// Returns the same of a unit with or without brackets around it, or with a power of ten in front.
bool isKnownUnit(std::string_view text);

/// Returns the number of metres in one of this unit: "m", "mm", "\u00B5m", "um", "microns", "nm",
/// "\u00C5", "in", "mil", "1e-6 m", "10^-9 m", with or without brackets; letters large or small.
/// A number in front has to be a power of ten. Empty where the text is no unit of length.
std::optional<double> metresPer(std::string_view unit);

/// A power of a length: metres^power is one of the unit in SI.
struct LengthPower {
  double metres = 1;
  int power = 1;
};

/// Reads a unit such as "1/um", "rad/m", "cycles/m", "nm^-1", "m^3", "um\u00B3", "mm", "um^2 mm",
/// "um^2/(1/mm)". Empty where the text is none.
std::optional<LengthPower> parseLengthPower(std::string_view text);

}  // namespace asperity
