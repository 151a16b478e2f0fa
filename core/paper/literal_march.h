// The algorithm of Li et al. 2013 as the paper describes it, for comparisons: N separate elements
// at the nodes of the line, which slides by one spacing in each time step dt = dx / v, N steps.
//
// In each step, with y = -u >= 0 the depth of an element and c = v tau:
//   out of contact  G u + eta u' = 0, that is y exp(-dt / tau)                  (Eq. 1, f = 0)
//   in contact      where d - z reaches that depth (u < z - d is violated) and
//                   f = 4 dx {G (d - z) + eta v z'} > 0                         (Eq. 2)
//   indentation     so that the forces of the elements in contact add up to F_N  (Eq. 3)
//   friction        F_x = sum of f z'                                           (Eq. 4)
// The rate of d is left out, as in the paper. z' is the line's own slope at the node.
//
// Finding d. Each element enters at one indentation, so the contact set only grows with d and
// F_N(d) rises, and is linear for any one set. The d of the last step gives a set, and Eq. (3) for
// that set gives a better d, until the set no longer changes; bisection is the safeguard. This is
// exact and costs one sweep over the elements per step once sliding is steady, the paper's "not
// iterative" (plain bisection would need about fifty). F_N(d) jumps where an element enters under
// pressure. Where F_N falls into such a jump no d gives it: the element is included, friction is
// F_x over the force that was found, and a step costs four to twenty sweeps.
//
// Plain loops over contiguous arrays; the line is stored twice in a row, so that a shifted line is
// an offset. Pure function; any thread. No exceptions except for allocation.
#pragma once

#include <cstdint>
#include <span>

#include "core/contact/steady_sliding.h"
#include "core/surface/line.h"

namespace asperity {

/// Means over the last fifth of the steps.
struct LiteralResult {
  double mu = 0;               // F_x / F_N of each step, averaged
  double normalForce = 0;      // N, reached; above the given one where that falls into a jump
  double tangentialForce = 0;  // N, Eq. (4)
  double indentation = 0;      // m, from the lowest node
  double contactFraction = 0;  // elements with f > 0
  double largestResidual = 0;  // |F_N - given| / given over the steps without a jump
  double jumpFraction = 0;     // part of the steps whose given force falls into a jump
  std::int64_t steps = 0;      // done
  double sweepsPerStep = 0;    // to find d; mean over all steps
};

/// The vectors for which the loops are compiled: those of the whole program, or wider ones, for
/// comparisons with the same instruction set. Sums differ in their last digits between them.
enum class LiteralVectors { AsCompiled, Avx2, Avx512 };

/// Returns whether this machine has these vectors.
bool isSupported(LiteralVectors vectors);

struct LiteralOptions {
  std::int64_t steps = 0;  // 0: N steps; fewer only to measure the time per step
  /// Depths y >= 0 (m) of all N elements one step before the first, and a first guess of the
  /// indentation (m); empty: a flat elastomer. A march that starts steady shows the cost of a
  /// steady step.
  std::span<const double> startDepth{};
  double startIndentation = 0;
  LiteralVectors vectors =
      LiteralVectors::AsCompiled;  // the only choice where others are not available
};

/// Slides the line towards +x; at first element i is under node i. normalForce: N, > 0; velocity
/// and relaxation time > 0.
LiteralResult literalMarch(const Line& line, const SlidingConditions& conditions,
                           double normalForce, const LiteralOptions& options = {});

}  // namespace asperity
