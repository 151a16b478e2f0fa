// Steady passes of resolved_pass.h over a line of straight segments, which need not be gone along
// from edge to edge. Where the line is w deep in the elastomer, w exp(s/c) rises with s where the
// pressure p is above 0 and falls where it is below; a free surface keeps its own. So the line is
// in contact exactly where w exp(s/c) is higher than anywhere before: its summits, where p falls
// through 0, are found many at a time, one look along them tells which overtop all before, and only
// those have edges of contact, which then are known to lie apart from each other and are found many
// at a time as well.
// Compiled for several instruction sets; the best one that the machine has is chosen at run time.
// Functions of their arguments; any thread. No allocation.
#pragma once

#include "core/contact/kernels/pass_queue.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// Runs the passes of the queue's stream 0 over a line of straight segments, one after another,
/// until it is given no other.
void passStraight(const PreparedProfile& line, PassQueue& queue);

}  // namespace asperity
