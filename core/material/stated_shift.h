// The shift with temperature that a text states beside a master curve or a Prony series. Pure
// functions; any thread. Failure: InputError that names the file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/text_table.h"
#include "core/material/elastomer.h"

namespace asperity {

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
