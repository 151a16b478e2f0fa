// What always holds of a steady result, as checks that the table of hard cases, the random scenes
// and the regressions share. Each check says how far it is from holding. Pure functions.
#pragma once

#include <string>
#include <vector>

#include "core/contact/steady_sliding.h"
#include "core/surface/line.h"

namespace asperity {

/// One line, slid at one velocity under one load.
struct Situation {
  Line line;
  Scheme scheme = Scheme::Cubic;
  SlidingConditions conditions;
  Load load;
};

struct Finding {
  std::string invariant;
  double value = 0;    // how far from holding; NaN fails
  double allowed = 0;  // at most
  bool holds() const { return value <= allowed; }
  double share() const;  // value / allowed; infinite where it does not hold at all
};

/// Both ways to the answer: one velocity at a time, and velocities side by side as in curves.
enum class Path { Plain, Lanes };
SteadyResult solve(const Situation& situation, Path path);

/// A clear refusal instead of numbers: the balance is not met, and the result says so.
bool isRefused(const SteadyResult& result);

/// Finite, in range, balanced, power and both ways to the force; of one result.
std::vector<Finding> resultFindings(const Situation& situation, const SteadyResult& result);

/// p >= 0, u <= z - d, complementarity, at every node of the shape at that indentation.
std::vector<Finding> shapeFindings(const Situation& situation, double indentation);

/// Never less force at more depth, around that indentation.
Finding forceGrowsWithDepth(const Situation& situation, double indentation);

/// Lengths, modulus and time scaled by powers of two: the same bits of mu.
Finding exactScaling(const Situation& situation, Path path, double mu);

/// The line moved along x by whole elements: the same mu.
Finding shiftSymmetry(const Situation& situation, Path path, const SteadyResult& result);

/// All of the above, of the plain path and of the lanes; of very long lines the first only. Empty
/// where the situation is refused.
std::vector<Finding> allFindings(const Situation& situation);

/// The finding nearest to its limit, or beyond it.
Finding worstOf(const std::vector<Finding>& findings);

}  // namespace asperity
