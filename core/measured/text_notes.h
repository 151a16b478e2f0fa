// Notes on what a text file of a surface states beside its numbers and the reader does not apply:
// other counts, units and steps, factors, lines left out. Only the readers of text in this folder
// use it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/text_table.h"
#include "core/measured/surface_draft.h"

namespace asperity {

/// Adds a note where the name of a column states a factor: "z (um) x100". It does not say whether
/// the numbers have it or need it.
void noteFactor(const TextBlock& block, int column, std::vector<Message>& notes);

/// Adds notes on what the file states otherwise than the draft has it, and what the reader can only
/// suppose. lineOfCount: a line that states how many numbers follow; 0: there is none.
void noteStatements(const TextTable& table, const TextBlock& block, const SurfaceSource& source,
                    std::uint32_t lineOfCount, SurfaceDraft& draft);

}  // namespace asperity
