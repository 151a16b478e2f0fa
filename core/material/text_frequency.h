// Frequencies in texts: their units, in the names of columns and in the lines above a table. Pure
// functions; any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "core/base/text_table.h"

namespace asperity {

/// Returns one unit of frequency in Hz; nothing where the text is none. An empty text means Hz, or
/// rad/s for omega.
std::optional<double> frequencyUnit(std::string_view unit, bool isAngular);

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
