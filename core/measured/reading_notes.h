// Says in sentences how a file of a surface was read, what was assumed, and what is unusual about
// its heights. Pure; any thread.
#pragma once

#include <string>

#include "core/measured/surface_draft.h"

namespace asperity {

/// Returns a unit of the file as people write it: "um" is "\u00B5m".
std::string printedUnit(const std::string& unit);

/// Completes the notes of a draft: first how the reader understood the file and what had to be
/// assumed, then what is special about it.
void addReadingNotes(SurfaceDraft& draft);

}  // namespace asperity
