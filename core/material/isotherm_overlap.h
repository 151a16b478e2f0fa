// The shift between two neighbouring isotherms: one is moved along the logarithm of frequency until
// both agree where they overlap. master_curve.h adds these shifts up. What the residuals say about
// a shift: how large the noise of the moduli is, and whether it explains what a vertical shift, or
// different shifts of both moduli, would explain as well. Pure functions; any thread; equal input
// gives equal bits.
#pragma once

#include <span>
#include <vector>

#include "core/base/statistics.h"
#include "core/material/isotherms.h"

namespace asperity {

/// One more unknown of the overlap of two isotherms, by least squares beside those of the shift.
/// Its value is linear in the logarithms of the moduli, so that its variance is a sum over them.
struct Contrast {
  double value = kNaN;                   // decades; NaN: not determined
  double storageGain = 0, lossGain = 0;  // its variance per variance of one value of the modulus
  double shiftChange = 0;                // decades, by which log10 a_T changes with this unknown
  double explained = 0;                  // decades^2, by which the squares of the residuals fall
};

/// The residuals of one overlap.
struct OverlapResiduals {
  Contrast vertical;                  // log10 b_T of the colder isotherm over that of the warmer
  Contrast difference;                // shift from G'' less that from G'
  Contrast differenceBesideVertical;  // the same where there is a vertical shift as well
  /// Standard error of log10 b_T from the moduli alone, decades: infinite where both are power laws
  /// of one exponent within their noise, so that a vertical shift is a horizontal one. NaN: there
  /// are no residuals to tell.
  double verticalError = kNaN;
  double squares = 0;           // decades^2, of the fit without these unknowns
  double values = 0;            // number of moduli
  double degreesOfFreedom = 0;  // number of its values beyond that of its unknowns
  struct Modulus {
    // Of the fit with all unknowns: squares, and the same for the products of neighbours along the
    // frequency, with what these are in the mean where the noise is white.
    double squares = 0, degreesOfFreedom = 0, products = 0, whiteProducts = 0, neighbours = 0;
    // Of each isotherm about a curve of its own: noise, whatever the isotherms have in common.
    double noiseSquares = 0, noiseFreedom = 0;
  };
  Modulus storage, loss;
};

/// The deviations of all overlaps of a master curve together, and tests against them. A test says
/// true for noise alone in 0.3 % of all master curves, whatever the number of their overlaps: the
/// largest of the values counts as one of many, and all of them together may be significant where
/// none is.
class OverlapNoise {
 public:
  /// Deviations are those of the fits with all unknowns (Misfit), which have what no shift explains
  /// and are correlated along the frequency, or those of each isotherm about its own curve (Noise).
  enum class Of { Misfit, Noise };
  OverlapNoise(std::span<const OverlapResiduals> overlaps, Of of);

  /// Returns the variance of a shift over that with white deviations. Means of correlated ones are
  /// no better for many points.
  double correlation() const { return correlation_; }

  /// Returns the values over their standard errors; 0 where one is not determined. An overlap that
  /// scatters more than all of them has its own noise.
  std::vector<double> deviations(Contrast OverlapResiduals::*contrast) const;

  bool areSignificant(const std::vector<double>& deviations) const;

  /// Returns the misfit (decades of modulus, rms) that neither noise nor shifts explain; 0 where it
  /// may be noise.
  double misfitOfShape() const;

 private:
  double ownScale(const OverlapResiduals& overlap) const;

  std::span<const OverlapResiduals> overlaps_;
  Of of_;
  double storage_ = 0, loss_ = 0;  // decades^2, variance of one value
  double freedom_ = 0;
  double correlation_ = 1;
};

/// The relation of two neighbouring isotherms, by least squares. Over the common range both are one
/// polynomial in the logarithm of frequency for each modulus (of degree 1 to 4, as the number and
/// the noise of the points allow); the shift is the unknown that moves one isotherm against the
/// other; all relative deviations have equal weight. The standard errors follow from the covariance
/// of all unknowns and the residuals; they are NaN where no residuals are left to estimate them.
struct Overlap {
  double log10Shift = 0;     // decades, log10 of a_T of the colder over that of the warmer
  double standardError = 0;  // decades
  double log10Vertical = 0;  // decades, log10 of b_T of the colder over that of the warmer
  double verticalError = 0;  // decades
  double ofEntropy = 0;      // decades, part of log10Shift that the law b_T ~ T makes
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
  Estimate storage, loss;        // decades
  OverlapResiduals residuals{};  // of the fit of both
};

/// Returns the shifts that bring an isotherm onto the next warmer one. isVertical: whether the
/// moduli are shifted, too. Throws InputError where no shift does, and where the warmer isotherm is
/// clearly the slower one: then the temperatures are mixed up.
NeighbourShifts neighbourShifts(const Isotherm& cold, const Isotherm& warm, bool isVertical);

}  // namespace asperity
