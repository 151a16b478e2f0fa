// Which of several tables of numbers in a text file holds the heights. Only the readers of text in
// this folder use it.
#pragma once

#include <cstddef>
#include <optional>

#include "core/base/message.h"
#include "core/base/text_table.h"

namespace asperity {

/// The table of the heights, and what there is to say about the choice.
struct HeightTable {
  std::size_t index = 0;  // in TextTable::blocks
  std::optional<Message> note{};
};

/// Chooses the table with the most numbers; of equal ones the one that is named as heights, else
/// the first. A table named as an intensity, such as "Light", gives way to one of heights.
HeightTable chooseHeightTable(const TextTable& table);

}  // namespace asperity
