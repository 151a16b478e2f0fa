// The indentation at which a steadily sliding line carries a given force. Pure functions.
// For resolved lines F_N(d) is increasing and convex: Newton's method from the right. For nodal
// lines it jumps; where the target falls into a jump the element that enters is partly loaded.
#pragma once

#include "core/contact/kernels/nodal_pass.h"
#include "core/contact/kernels/pass_sums.h"
#include "core/contact/line/prepared_profile.h"

namespace asperity {

/// Relative error of F_N beyond which a balance is not accepted.
inline constexpr double kAcceptedResidual = 1e-10;
/// Relative error of F_N at which iteration ends.
inline constexpr double kWantedResidual = 1e-13;

/// Passes over a resolved line before a balance is given up.
inline constexpr int kMostPasses = 200;
/// Passes without a smaller residual before the best one is taken.
inline constexpr int kPatience = 2;

struct Balance {
  double depth = 0;     // m, indentation below the lowest point
  int passes = 0;       // over the line
  double residual = 0;  // |F_N - target| / target
  bool isMet() const { return residual <= kAcceptedResidual; }
};

/// load = F_N / 4G (m^2, > 0). guess: a depth near the answer (m), or 0.
Balance balanceResolved(const PreparedProfile& line, double memoryLength, double load,
                        double guess = 0);

struct NodalBalance {
  Balance balance;
  NodalState state;  // at that depth; the marginal element counted by its share
  double marginalShare =
      1;  // of the load that the entering element would carry; 1: none is partial
};

NodalBalance balanceNodal(const PreparedProfile& line, double memoryLength, double load);

}  // namespace asperity
