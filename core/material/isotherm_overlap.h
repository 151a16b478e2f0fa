// The shift between two neighbouring isotherms: one is moved along the logarithm of frequency until
// both agree where they overlap. master_curve.h adds these shifts up. Pure functions; any thread;
// equal input gives equal bits.
#pragma once

#include "core/material/isotherms.h"
#include "core/material/overlap_residuals.h"

namespace asperity {

/// The relation of two neighbouring isotherms, by least squares. Over the common range both are one
/// polynomial in the logarithm of frequency for each modulus (of degree 1 to 4, as the number of
/// points allows); the shift is the unknown that moves one isotherm against the other; all relative
/// deviations have equal weight. The standard errors follow from the covariance of all unknowns and
/// the residuals; they are NaN where no residuals are left to estimate them.
struct Overlap {
  double log10Shift = 0;     // decades, log10 of a_T of the colder over that of the warmer
  double standardError = 0;  // decades
  double log10Vertical = 0;  // decades, log10 of b_T of the colder over that of the warmer
  double verticalError = 0;  // decades
  double mismatch = 0;       // decades of modulus, rms difference of the two where they overlap
  double decades = 0;        // of frequency that they have in common
  /// Whether the moduli do not tell a vertical shift from a horizontal one (to 5 %): both are power
  /// laws of one exponent within their noise.
  bool isVerticalOpen = false;
};

/// The shifts that follow from both moduli, and from each alone. An estimate that is not available
/// is NaN.
struct NeighbourShifts {
  Overlap both;
  ShiftEstimate storage, loss;
  OverlapResiduals residuals{};  // of the fit of both
};

/// Returns the shifts that bring an isotherm onto the next warmer one. isVertical: whether the
/// moduli are shifted, too. Throws InputError where no shift does, and where the warmer isotherm is
/// clearly the slower one: then the temperatures are mixed up.
NeighbourShifts neighbourShifts(const Isotherm& cold, const Isotherm& warm, bool isVertical);

}  // namespace asperity
