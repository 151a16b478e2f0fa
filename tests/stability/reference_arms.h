// Steady sliding of elements with arms once more, plain and slow, in the widest numbers of the
// machine: what the double precision of core/contact's passes with arms is measured against. It
// shares no code with them: particular solutions and Gauss's points instead of recurrences and
// series, bisection for every edge, differences for the slopes of Newton's method. Pure functions.
#pragma once

#include <span>

#include "core/material/element_law.h"
#include "tests/stability/reference_pass.h"

namespace asperity {

/// Sliding towards +x under a load. law: with an equilibrium modulus and arms; the answer is looked
/// for from a depth (m) and strains of the arms at the lowest point (m) nearby. residual of the
/// result: what is left of balance and period, relative.
ReferenceResult referenceWithArms(const Line& line, Scheme scheme, const ElementLaw& law,
                                  double velocity, const Load& load, double depth,
                                  std::span<const double> strains);

}  // namespace asperity
