// Steady sliding with everything in contact: the search for edges of contact is left out, because
// depth and friction are known (Li et al. 2013, Eqs. 3 and 8, of the line as resolved). Whether
// contact is complete is not guessed: bounds over blocks of the line prove it, and where they do
// not, the segments themselves are looked at.
// Pure functions for elements without arms, on linear and cubic segments; any thread; no
// allocation.
#pragma once

#include "core/contact/kernels/pass_sums.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// Whether pressure is above 0 along the whole line at this depth (m). memoryLength: c = v tau (m).
/// Cheap where the answer is clear.
bool isContactComplete(const PreparedProfile& line, double depth, double memoryLength);

/// The depth (m) above which it is: max(rise + c rise').
double completeAbove(const PreparedProfile& line, double memoryLength);

/// The depth (m) at which complete contact carries a load = F_N / 4G (m^2).
inline double depthOfComplete(const PreparedProfile& line, double load) {
  return load / line.length + line.meanRise;
}

/// What a result states of complete contact at that depth; absoluteSlope is not gathered: NaN.
StateSums completeState(const PreparedProfile& line, double depth, double memoryLength);

}  // namespace asperity
