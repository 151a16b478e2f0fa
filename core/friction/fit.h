// Straight lines through points by least squares, with the uncertainties of their coefficients.
// Pure; any thread.
#pragma once

#include <span>

namespace asperity {

/// y = intercept + slope x. The standard errors come from the scatter about the line (Numerical
/// Recipes, 15.2, with the errors of the points unknown); NaN with two points, which have none.
struct LineFit {
  double intercept = 0, slope = 0;
  double interceptError = 0, slopeError = 0;
  double rmsResidual = 0;
};

/// Points of equal weight; x and y of one length, at least two different x. The slope of a plateau,
/// where y does not change but in its last digits, is 0.
LineFit fitLine(std::span<const double> x, std::span<const double> y);

/// A power law, ln y = intercept + slope ln x; all values positive.
LineFit fitPower(std::span<const double> x, std::span<const double> y);

}  // namespace asperity
