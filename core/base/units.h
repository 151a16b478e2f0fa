// Units of measurement in texts: the one table of units, quantities as people type them ("20mN",
// "10 MPa", "40 \u00B0C"), and why one is refused. text_units.h finds units in the names of
// columns. Pure; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.h"

namespace asperity {

inline constexpr double kZeroCelsius = 273.15;  // K

/// A unit. A number in it becomes one of the SI unit by (number + offset) size 10^exponent; the
/// power of ten stands apart so that "20 mm" is exactly the number 0.02.
struct Unit {
  std::string_view si;  // "Pa"; empty: a pure number
  int exponent = 0;
  double size = 1, offset = 0;

  double toSi(double number) const;
  bool operator==(const Unit&) const = default;
};

/// Returns the unit with this name: an SI unit with a prefix from f to P ("kPa s", "\u00B5m",
/// "mm/s"), or another common one ("bar", "\u00B0C", "km/h", "min", "%"). Upper and lower case
/// differ in short names ("mPa", "MPa"). Empty where it is none.
std::optional<Unit> findUnit(std::string_view name);

/// Returns the same where it measures what the SI unit measures. "m" is a length, and in a table of
/// times it may not be minutes: only units of `si` are looked at.
std::optional<Unit> findUnit(std::string_view name, std::string_view si);

/// Returns the same as instruments write it, in any case where that leaves no doubt: "KHZ", "MPA"
/// and "mpa" (megapascals, for nobody measures rubber in millipascals), "MS" (milliseconds). What
/// isFemtoUnit names is none.
/// A power of ten may stand in front, "10^-3 m/s", or alone for a pure number; "100 N" is no unit,
/// because it may be a load.
std::optional<Unit> unitInAnyCase(std::string_view name, std::string_view si);

/// Returns whether the name would mean femtonewtons, femtopascals or femtometres per second, which
/// no table has: "FN" and "Fn" are symbols of the normal force.
bool isFemtoUnit(std::string_view name);

/// Returns how many of the SI unit one of such a unit is, also with a power of ten in front of it:
/// "10^6 Pa". Empty where it is none.
std::optional<double> unitSize(std::string_view name, std::string_view si);

/// Returns one unit of frequency in Hz: "kHz", "rpm", "1/s", or of angular frequency: "rad/s",
/// "krad/s", "deg/s". "1/s" of an angular frequency is a radian per second. Empty where it is none.
std::optional<double> frequencySize(std::string_view unit, bool isAngular);

/// Returns "Pa, kPa, MPa, GPa, kN/m2, ..., psi": the units that measure what the SI unit measures,
/// with their usual prefixes and without other spellings, for messages.
std::string unitNames(std::string_view si);

/// The kind of number that is expected.
struct QuantityRule {
  std::string_view unit{};     // SI; empty for a pure number
  bool isTemperature = false;  // on the absolute scale: degrees Celsius are accepted, too
  bool isWhole = false;        // whole numbers have no per cent
};

/// A quantity as it was typed.
struct TypedQuantity {
  std::optional<double> value;  // in the SI unit
  Message refusal{};            // why the unit is refused; empty where there is no number at all
  bool isTooLarge = false;      // beyond what a number can hold
};

/// Reads "20mN", "20 mN" or "0.02", which is in the SI unit; the decimal sign is a point.
TypedQuantity typedQuantity(std::string_view text, const QuantityRule& rule);

}  // namespace asperity
