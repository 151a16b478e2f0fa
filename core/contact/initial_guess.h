// Depths found so far at several forces and velocities of one line, and what they say about the
// next one. It changes what a balance costs, not its answer beyond the residual.
#pragma once

#include <array>
#include <span>

#include "core/contact/steady_sliding.h"

namespace asperity {

/// results[row * velocities.size() + column], a row for each force (N, ascending), a column for
/// each velocity (m/s, ascending); passes is 0 where a result is still to come.
struct InitialGuess {
  std::span<const double> forces, velocities;
  std::span<SteadyResult> results;
  /// Those of another line with the same spectrum, or none: depths over those at rest are alike.
  std::span<const SteadyResult> others;
  /// Depths (m) of the line at rest, of the last few rows, row k at k % kRests.
  static constexpr std::size_t kRests = 4;
  std::array<double, kRests> rests{};

  SteadyResult& at(std::size_t row, std::size_t column) const {
    return results[row * velocities.size() + column];
  }
  bool isKnown(std::size_t row, std::size_t column) const { return at(row, column).passes > 0; }

  /// A depth (m) near the answer there.
  double guess(std::size_t row, std::size_t column) const;

 private:
  double expected(std::size_t row, std::size_t column) const;
  double excess(std::size_t row, std::size_t column) const;
  double fromForces(std::size_t row, std::size_t column) const;
};

/// The n-th of `count` columns in the order in which they are best computed: every eighth, then
/// those halfway, and so on, so that most lie between known ones.
std::size_t columnInOrder(std::size_t n, std::size_t count);

}  // namespace asperity
