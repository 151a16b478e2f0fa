// What a text beside its table of moduli, or of a Prony series, states about temperatures: that of
// the test, and the shift. Pure functions; any thread.
// Failure: InputError that names the file and the line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/text_table.h"
#include "core/material/elastomer.h"

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

/// Returns whether a text states a shift that statedShift would read.
bool statesShift(const TextTable& table);

/// Returns whether a block is a table of shift factors.
bool isShiftTable(const TextBlock& block);

}  // namespace asperity
