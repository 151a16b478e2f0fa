// The temperature of the test among those that the lines above a table state, and the shift with
// temperature that a text states beside a master curve or a Prony series. stated_temperature.cpp
// and stated_shift.cpp share this header. Pure functions; any thread. Failure: InputError that
// names the file and the line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"
#include "core/base/text_table.h"
#include "core/material/elastomer.h"

namespace asperity {

/// A temperature above a table, and the line that states it.
struct HeaderTemperature {
  double kelvin = 0;
  std::size_t line = 0;  // 0: the name of the file
  std::string text{};
};

/// Returns the temperature that is stated above a block, in its own header or else in the nearest
/// earlier one. An entry with a key for it ("Temperature: 20 °C", "T/K = 293", "Tref = 20 °C")
/// precedes a sentence about the test ("measured at 20 °C"), and this one a temperature that stands
/// alone. Each clause of a line counts for itself. Temperatures of other things do not count:
/// rates, tolerances, ranges, limits, glass transition, making and storing the sample, and names;
/// nor do those beside a duration or a word that may be about a treatment. The reference of the
/// constants of a shift counts where nothing else is stated. unit: the user's choice, or empty.
/// isReduced: whether the table is a master curve, for which a reference temperature precedes one
/// of the test. Throws InputError where two different temperatures are stated, or one below
/// kColdestTest.
std::optional<HeaderTemperature> statedTemperature(const TextPart& in, const std::string& name,
                                                   const std::string& unit, bool isReduced);

/// Returns the temperature that the lines below the last table state as lines above it would.
std::optional<HeaderTemperature> temperatureBelow(const TextTable& table, const std::string& name,
                                                  const std::string& unit, bool isReduced);

/// Returns the temperature above a block that statedTemperature does not take for that of the test,
/// of the first line with one.
std::optional<HeaderTemperature> distrustedTemperature(const TextPart& in);

/// Returns the one temperature that the name of a file states as a line above a table would:
/// "NR-CB50_23C.csv", "Sample 3 (60 °C).txt".
std::optional<HeaderTemperature> temperatureInName(const std::string& fileName);

/// Returns the reference temperature (K) of the constants C1 and C2 of a shift: one in a line about
/// them ("WLF: Tref = 20 °C; C1 = 10"), else the reference temperature of any header. isOfGlass:
/// whether a glass transition temperature is one where nothing else is stated. The last of several
/// counts.
std::optional<double> statedShiftReference(const TextTable& table, const std::string& unit,
                                           bool isOfGlass);

/// Returns "temperature" where a name in lower case, which may be empty, and a unit are those of
/// the temperature of a test; otherwise an empty text.
std::string temperatureNamed(const std::string& name, const std::string& unit);

/// Moves the lines below the table of measurements or of a series above it, where a temperature and
/// a shift are looked for; only those that state a temperature, a constant of a shift or a modulus
/// of a series and nothing else, and only where the table is the last one, no other table has
/// measurements, no line above states a temperature as they do, the name of the file states no
/// other one, and each other line below states another quantity.
void moveLinesAbove(TextTable& table, const std::string& name);

// ---- The shift, of master curves and Prony series

struct StatedShift {
  std::optional<TemperatureShift> shift{};
  std::vector<Message> notes{};  // what was read, and what is left out
};

/// Returns the shift that a text states beside a master curve or series at one temperature (K):
/// WLF constants C1 and C2 above the table, or a table of its own with the columns temperature and
/// log aT (or ln aT, or aT). Constants of another reference temperature are converted to this one.
/// Throws InputError for constants that no scene accepts.
StatedShift statedShift(const TextTable& table, double temperature, const std::string& name,
                        const std::string& unit);

/// How the numbers of a column state shift factors.
struct ShiftNotation {
  bool isLogarithm = true;  // otherwise the factor itself
  double decades = 1;       // of log10 aT for 1 in the column: 0.434 of "ln aT", -1 of "-log aT"

  double log10Shift(double number) const;
};

/// Returns the notation of a column with this name: "log aT", "-lg a_T", "ln(aT)", "shift factor";
/// nothing where it has no shift factors.
std::optional<ShiftNotation> shiftNotation(std::string_view column);

/// Returns whether a text states a shift that statedShift would read.
bool statesShift(const TextTable& table);

/// Returns whether a block is a table of shift factors.
bool isShiftTable(const TextBlock& block);

}  // namespace asperity
