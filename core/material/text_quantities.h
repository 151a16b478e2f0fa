// Temperatures and frequencies in texts, as people write them: "20 \u00B0C", "-20 deg. C", "293 K",
// "68F", "10 Hz"; and the sizes of the units of tables about rubber. Pure functions; any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text_table.h"
#include "core/base/units.h"

namespace asperity {

/// The coldest temperature (K) at which a rubber is measured: colder than liquid air. Smaller
/// numbers are steps, tolerances and degrees Celsius.
inline constexpr double kColdestTest = 100;

/// Without a unit, numbers from here on are kelvins: no rubber is used above 200 degrees Celsius.
inline constexpr double kLowestKelvins = 200;

/// Returns the unit of temperatures that state none. lowest: the lowest of their numbers.
constexpr const char* assumedTemperatureUnit(double lowest) {
  return lowest >= kLowestKelvins ? "K" : "\u00B0C";
}

/// A temperature in a text, from its number to the end of its unit.
struct TextTemperature {
  double kelvin = 0;
  std::size_t begin = 0, end = 0;
  double number = 0;        // as written, with its sign
  std::string_view unit{};  // "C", "K" or "F"
  bool isLetter = false;    // whether the unit is written as the letter C or F alone
};

/// Returns the first temperature in a text; it needs a unit: "sweep at 20 \u00B0C", "T = 293 K". A
/// rate as "2 K/min" is none.
std::optional<TextTemperature> firstTemperature(std::string_view text);

/// Returns the same in K.
std::optional<double> findTemperature(std::string_view text);

/// Returns all temperatures in a text, in their order; K.
std::vector<double> findTemperatures(std::string_view text);

/// Reads a whole text as a temperature, in K: "20C", "20 \u00B0C", "68F", "293.15", "293.15K"; a
/// number alone is in K. Nothing where the text is none.
std::optional<double> parseTemperature(std::string_view text);

/// Returns a unit of temperature: "\u00B0C", "deg. C", "c", "K", "Fahrenheit"; nothing where the
/// text is none.
std::optional<Unit> temperatureUnit(std::string_view unit);

/// Returns one unit of frequency in Hz; nothing where the text is none. An empty text means Hz, or
/// rad/s for omega.
std::optional<double> frequencyUnit(std::string_view unit, bool isAngular);

/// Reads a strain, "1%" or "0.01"; nothing where the text is no number above 0.
std::optional<double> parseStrain(std::string_view text);

/// Returns one unit of strain as a ratio: 0.01 for "%", 1 for "mm/mm" or no unit; nothing where the
/// text is none, as "mm".
std::optional<double> strainUnit(std::string_view unit);

/// Returns one unit of viscosity in Pa s; nothing where the text is none.
std::optional<double> viscosityUnit(std::string unit);

/// Returns one unit of compliance, "1/MPa" or "mm\u00B2/N", in 1/Pa; nothing where the text is
/// none.
std::optional<double> complianceUnit(std::string_view unit);

/// Returns one unit of angle in radians; nothing where the text is none.
std::optional<double> angleUnit(std::string_view unit);

/// Returns the size of a unit of time in s; nothing where it is none.
std::optional<double> timeSize(std::string_view unit);

/// Returns the size of a unit of modulus in Pa; what stands after it in a header does not count:
/// "3 MPa (at 20 °C)". Throws InputError (`name`, `key`) where it is none.
double modulusSize(const std::string& unit, const std::string& name, const std::string& key);

/// A frequency with its unit in a text.
struct TextFrequency {
  double hertz = 0;
  std::size_t begin = 0, end = 0;
};

/// Returns the first frequency with its unit in a text: that of "E' 10 Hz". Nothing where there is
/// none.
std::optional<TextFrequency> firstFrequency(std::string_view text);

/// Returns the one frequency (Hz) that the lines above a block state, "Frequency: 1 Hz", "10 Hz";
/// nothing where they state none, or several.
std::optional<double> statedFrequency(const TextBlock& block);

}  // namespace asperity
