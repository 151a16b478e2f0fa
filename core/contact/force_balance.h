// The indentation at which a steadily sliding resolved line carries a given force. F_N(d) rises and
// is convex, and in logarithms it is nearly straight: safeguarded Newton steps in ln d over ln F_N,
// from the second pass on with the cubic through the last two passes. Complete contact and the line
// at rest need no search for edges of contact. Nodal lines jump instead: kernels/nodal_balance.h.
// Functions of their arguments, for elements without arms; any thread; no allocation.
// relaxationLength: c = v tau (m). load = F_N / 4G (m^2, > 0).
#pragma once

#include <stop_token>

#include "core/contact/kernels/pass.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// Tolerance of the force balance: the relative error of F_N above which it is not accepted.
inline constexpr double kAcceptedResidual = 1e-10;
/// Relative error of F_N below which the iteration ends.
inline constexpr double kTargetResidual = 1e-13;

/// The result of a balance.
struct Balance {
  double depth = 0;     // m, indentation below the lowest point
  int passes = 0;       // number of passes over the line
  double residual = 0;  // |F_N - target| / target
  bool isMet() const { return residual <= kAcceptedResidual; }
};

/// The balance of one line at one velocity and force, one pass at a time: the caller runs the pass
/// at the requested depth and returns its sums, so that many balances can run side by side. A plain
/// value; no allocation.
class ForceBalance {
 public:
  /// guess: a depth near the answer (m), or 0.
  void start(const PreparedProfile& line, double load, double guess);

  bool isDone() const { return done_; }
  /// Returns the depth (m) of the next pass.
  double depth() const { return depth_; }
  /// Takes the sums of a pass at depth().
  void take(const PassSums& sums);

  /// Returns the best pass so far, and its sums.
  Balance balance() const { return {bestDepth_, passes_, residual_}; }
  const PassSums& sums() const { return bestSums_; }

 private:
  struct Pass {
    double excess;  // ln(F_N / target)
    double slope;   // d ln depth / d ln F_N
    double depth;   // m
  };

  void move(const PassSums& sums);

  double load_ = 0;
  double low_ = 0, high_ = 0;  // m, bracket of the solution
  double complete_ = 0;        // m, the solution if contact is complete
  double depth_ = 0, bestDepth_ = 0, residual_ = 0;
  PassSums bestSums_;
  Pass last_{};
  int passes_ = 0, stalled_ = 0;
  bool done_ = false, triedComplete_ = false;
};

/// Solves the balance with plain passes.
Balance balanceResolved(const PreparedProfile& line, double relaxationLength, double load);

// ---- Contact from the bounds over blocks of a line: whether it is complete, depth and friction in
// complete contact (Li et al. 2013, Eqs. 3 and 8, of the resolved line), and the indentation at
// rest. Complete contact is not guessed: where the bounds do not prove it, the segments themselves
// are examined.
/// Returns whether the pressure is above 0 along the whole line at this depth (m). It is fast in
/// clear cases.
bool isContactComplete(const PreparedProfile& line, double depth, double relaxationLength);

/// Returns the depth (m) above which contact is complete: max(z + c dz/ds).
double completeAbove(const PreparedProfile& line, double relaxationLength);

/// Returns the depth (m) at which complete contact carries a load.
inline double completeContactDepth(const PreparedProfile& line, double load) {
  return load / line.length + line.meanHeight;
}

/// Returns the sums of a pass in complete contact at that depth.
PassSums completeContactSums(const PreparedProfile& line, double depth, double relaxationLength);

/// Returns a depth (m) close to the one that carries the load at rest. Sliding
/// carries more. Where `stop` is requested, it soon returns any depth.
double depthAtRest(const PreparedProfile& line, double load, const std::stop_token& stop = {});

}  // namespace asperity
