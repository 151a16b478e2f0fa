// What the columns of a table of dynamic moduli mean: names and units as rheometers, analysers
// (DMA) and people write them, in English and German. Pure functions; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/units.h"

namespace asperity {

enum class DmaQuantity {
  None,
  Frequency,
  ReducedFrequency,  // shifted to one temperature already
  Temperature,
  Storage,
  Loss,
  LossTangent,
  Magnitude,  // |G*|
  Phase,
  Strain,
};

enum class ModulusKind { Unknown, Shear, Tension };

struct DmaColumn {
  DmaQuantity quantity = DmaQuantity::None;
  ModulusKind kind = ModulusKind::Unknown;  // of a modulus
  bool isAngular = false;                   // of a frequency: omega by its name
  std::optional<double> temperature{};      // K, where the name states one: "G' (20 \u00B0C)"
  bool isDeviation = false;  // of another column: "G' std", "u(G')"; its quantity is none
  std::string unknown{};     // words beside the name of a modulus that are not understood: "fit"
  std::string words{};       // all of the name's words, by which equal names are recognized
};

/// "G'", "E_storage", "Storage modulus", "tan(delta)", "|E*|", "omega", "Temp.", "G'' @ 20
/// \u00B0C",
/// ... The unit helps where the name has a temperature in its brackets.
DmaColumn dmaColumn(std::string_view name, std::string_view unit);

/// A temperature amid a text, with its unit: "sweep at 20 \u00B0C", "T = 293 K"; in K.
std::optional<double> temperatureIn(std::string_view text);

/// All of them, in their order.
std::vector<double> temperaturesIn(std::string_view text);

/// "20C", "20 \u00B0C", "68F", "293.15", "293.15K"; a number alone is in K. Nothing where it is
/// none.
std::optional<double> temperatureFrom(std::string_view text);

/// Hz, of one unit; nothing where it is no unit of frequency. Empty: Hz, or rad/s for omega.
std::optional<double> frequencyUnit(std::string_view unit, bool isAngular);

/// "\u00B0C", "deg. C", "c", "K", "Fahrenheit"; nothing where it is no unit of temperature.
std::optional<Unit> temperatureUnit(std::string_view unit);

/// Radians, of one unit; nothing where it is no unit of angle.
std::optional<double> angleUnit(std::string_view unit);

/// Refuses moduli without a unit, the largest of which (`largest`, Pa) is below 1 kPa: read in Pa
/// they would be those of no rubber. `name` is the file's, `key` the column's. Throws InputError.
void refuseSoftModulus(const std::string& name, const std::string& key, double largest);

}  // namespace asperity
