// The indentation at which the paper's separate elements carry a given force. F_N(d) is a rising
// staircase of straight pieces: loaded elements only join as d grows, so two depths with the same
// number of loaded elements have the same ones, and between them F_N is straight. Where the numbers
// differ by one, the threshold of that element determines the solution. Where the target falls into
// a jump, the entering element is partly loaded: the solution is the combination of the two states
// that carries the force exactly.
#pragma once

#include <span>
#include <stop_token>

#include "core/contact/force_balance.h"
#include "core/contact/kernels/kernels.h"

namespace asperity {

struct NodalBalance {
  Balance balance;
  PassSums sums;  // at that depth; the entering element counts with its share
  // of the load that the entering element would carry; 1: no element is partly loaded
  double marginalShare = 1;
};

/// Solves the balance with passes in one lane. load = F_N / 4G (m^2, > 0); relaxationLength: c = v
/// tau (m).
NodalBalance balanceNodal(const PreparedProfile& line, double relaxationLength, double load);

/// Solves it for at most laneCount() relaxation lengths side by side, which share every pass.
/// guesses: depths nearby (m), or 0. Returns false where `stop` was requested. No allocation.
bool balanceNodalLanes(const PreparedProfile& line, std::span<const double> relaxationLengths,
                       double load, const LaneValues& guesses, const std::stop_token& stop,
                       std::span<NodalBalance> balances);

}  // namespace asperity
