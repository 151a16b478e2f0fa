// Which of several tables of numbers in a text file holds the heights. Only the readers of text in
// this folder use it.
#pragma once

#include <cstddef>
#include <optional>

#include "core/base/message.h"
#include "core/base/text_table.h"
#include "core/measured/surface_draft.h"

namespace asperity {

/// The table of the heights, and what there is to say about the choice.
struct HeightTable {
  std::size_t index = 0;  // in TextTable::blocks
  std::optional<Message> note{};
};

/// Joins tables of the same named columns where the positions of one go on from those of the table
/// before, as below names that a program repeats on each page. Returns how many of them the largest
/// table is made of.
std::size_t joinContinued(TextTable& table);

/// Chooses the table with the most numbers; of equal ones the one that is named as heights, else
/// the first. A table named as an intensity, such as "Light", gives way to one of heights.
HeightTable chooseHeightTable(const TextTable& table);

/// Replaces a table by several where blank lines separate it into parts of equally many rows, or
/// into profiles, or where the positions of a profile begin anew or a column numbers them, and
/// returns their number; 1: there are no such parts. The lines of points of one grid stay together,
/// and so do the rows of a matrix where the header states their number, or the user that they are
/// one.
std::size_t splitIntoParts(TextTable& table, std::size_t index, const SurfaceSource& source);

/// Returns the number of tables from this one on whose headings are those of profiles: "Profile 1",
/// "Profile 2" (isNextProfile).
std::size_t countHeadedProfiles(const TextTable& table, std::size_t index);

/// Throws InputError where the heights have the name of another quantity, such as "Intensity",
/// without a unit of length; adds a note where the user states the unit. column: of the heights;
/// -1: the table holds heights alone, and the lines above it may name it.
void requireHeightName(const TextBlock& block, int column, const SurfaceSource& source,
                       std::vector<Message>& notes);

}  // namespace asperity
