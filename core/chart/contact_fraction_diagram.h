// The part of the line that is in contact, over velocity, as a diagram: that of the present curve
// and of those beside it, and what theories say of it, where they hold. Pure; any thread.
#pragma once

#include "core/chart/curve_set.h"
#include "core/chart/diagram.h"

namespace asperity {

/// Returns the diagram of the set's curves. Eq. (11) says nothing about contact.
DiagramSheet contactFractionSheet(const CurveSet& set);

}  // namespace asperity
