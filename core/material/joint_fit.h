// The shifts of all isotherms and the curve of each modulus, fitted together. isotherm_overlap.h
// compares neighbours alone, over which a modulus is a polynomial. Pure functions; any thread;
// equal input gives equal bits.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/base/statistics.h"
#include "core/material/overlap_fit.h"

namespace asperity {

/// The result of a joint fit.
struct JointShifts {
  std::vector<Estimate> shifts{};  // decades; none where the moduli do not determine them
  double noise = kNaN;             // decades, of the moduli (geometric mean of the fitted ones)
};

/// Returns the shifts with their standard errors, counted from the weighted mean of the
/// shifts. Throws StopRequested within one pass
/// after `stop`.
///
/// The logarithm of each modulus over that of reduced frequency is a cubic spline whose knots are
/// closer than the points of one isotherm. The third differences of its coefficients are random
/// (P-splines: Eilers and Marx, Statistical Science 11, 89 (1996)). Their variance and that of the
/// noise follow from the moduli by restricted maximum likelihood (Wood and Fasiolo, Biometrics 73,
/// 1071 (2017)), so that the standard errors hold what the curve may do between the points.
///
/// sweeps: of rising temperature. start: shifts near the result, one for each sweep. weights: sum
/// to 1.
JointShifts jointShifts(std::span<const LogSweep> sweeps, const std::vector<double>& start,
                        const std::vector<double>& weights, ShiftModuli moduli,
                        const std::stop_token& stop);

}  // namespace asperity
