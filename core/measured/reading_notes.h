// Says in sentences how a file of a surface was read, what was assumed, and what is unusual about
// its heights. Pure; any thread.
#pragma once

#include "core/measured/surface_draft.h"

namespace asperity {

/// Completes the notes of a draft: first how the reader understood the file and what had to be
/// assumed, then what is special about it.
void addReadingNotes(SurfaceDraft& draft);

}  // namespace asperity
