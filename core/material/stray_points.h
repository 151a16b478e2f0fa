// Points of a sweep that are far from the curve of their neighbours, as by a slip of the decimal
// mark. Pure functions; any thread; equal input gives equal bits.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/message.h"
#include "core/material/isotherms.h"

namespace asperity {

/// A modulus that its neighbours along the frequency contradict.
struct StrayPoint {
  std::size_t isotherm = 0, point = 0;
  bool isLoss = false;
  double suggested = 0;  // Pa, by the points beside it

  double value(std::span<const Isotherm> isotherms) const;  // Pa
};

/// Returns the points that deviate by more than a factor of 1.5, and by far more than the scatter
/// of the others, from a polynomial through up to six points beside them; the worst come first.
/// Sweeps of fewer than five points have none.
std::vector<StrayPoint> strayPoints(std::span<const Isotherm> isotherms);

/// Returns an isotherm without its stray points. index: of the isotherm among those of the points.
Isotherm withoutStrays(const Isotherm& isotherm, std::size_t index,
                       std::span<const StrayPoint> strays);

/// Returns "G'' at -10 °C and 12 Hz is 0.2 MPa, where the points beside it suggest 2 MPa".
Message describe(const StrayPoint& stray, std::span<const Isotherm> isotherms);

}  // namespace asperity
