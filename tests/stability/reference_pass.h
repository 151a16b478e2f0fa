// The steady pass once more, plain and slow, in the widest numbers of the machine: what the double
// precision of the kernels is measured against. It shares no code with core/contact: heights above
// the lowest point instead of depths below the surface, bisection for every edge, Gauss's points
// for every integral. Pure functions.
#pragma once

#include "core/contact/steady_sliding.h"
#include "core/surface/line.h"
#include "tests/stability/reference_line.h"

namespace asperity {

struct ReferenceResult {
  Wide indentation = 0;       // m
  Wide mu = 0;                // resolved lines: from the power dissipated; nodal: Eq. (4)
  Wide contactFraction = 0;   // of the period
  Wide marginalShare = 1;     // nodal: of the load of the element on the edge; 1: none
  Wide periodicityError = 0;  // with arms: what is left of balance and period, relative
};

/// Sliding towards +x under a load. guess: a depth nearby (m), or 0; it changes the cost only.
ReferenceResult referenceSliding(const Line& line, Scheme scheme,
                                 const SlidingConditions& conditions, const Load& load,
                                 double guess = 0);

}  // namespace asperity
