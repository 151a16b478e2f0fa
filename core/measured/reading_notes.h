// Says in sentences how a file of a surface was read, what was assumed, what is unusual about its
// heights, and what a text file states beside its numbers that the reader does not apply. Pure; any
// thread.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/text_table.h"
#include "core/measured/surface_draft.h"

namespace asperity {

/// Completes the notes of a draft: first how the reader understood the file and what had to be
/// assumed, then what is special about it.
void addReadingNotes(SurfaceDraft& draft);

/// Adds a note where the name of a column states a factor: "z (um) x100". It does not say whether
/// the numbers have it or need it.
void noteFactor(const TextBlock& block, int column, std::vector<Message>& notes);

/// Adds notes on what the file states otherwise than the draft has it, and what the reader can only
/// suppose. lineOfCount: a line that states how many numbers follow; 0: there is none.
void noteStatements(const SurfaceText& in, std::uint32_t lineOfCount, SurfaceDraft& draft);

}  // namespace asperity
