// The temperature of the test among those that the lines above a table state. Pure functions; any
// thread.
// Failure: InputError that names the file and the line.
#pragma once

#include <optional>
#include <string>

#include "core/base/text_table.h"

namespace asperity {

/// Returns the temperature (K) that is stated above a block, in its own header or else in the
/// nearest earlier one. An entry with a key for it ("Temperature: 20 °C", "T/K = 293", "Tref = 20
/// °C") precedes a temperature in any other line ("sweep at 20 °C"). Temperatures of other things
/// do not count: rates, tolerances, ranges, limits, glass transition, vulcanization, oven and the
/// constants of a shift. unit: the user's choice, or empty. isReduced: whether the table is a
/// master curve, for which a reference temperature precedes one of the test. Throws InputError
/// where two different temperatures are stated, or one below kColdestTest.
std::optional<double> statedTemperature(const TextTable& table, const TextBlock& block,
                                        const std::string& name, const std::string& unit,
                                        bool isReduced);

/// Returns the reference temperature (K) that any header of the text states; the last one of
/// several.
std::optional<double> statedReference(const TextTable& table, const std::string& unit);

}  // namespace asperity
