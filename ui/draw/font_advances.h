// Advances of the embedded DejaVu Sans, from the font's own tables. Private to ui/draw; pure.
#pragma once

#include <cstdint>

namespace asperity {

inline constexpr float kAdvancesPerSize = 2048;

/// In units of 1/kAdvancesPerSize of the font's size; a character outside the table is a wide one.
std::int16_t fontAdvance(std::uint32_t character, bool bold);

}  // namespace asperity
