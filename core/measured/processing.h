// Turns the heights of one measured row into a profile without form and without short and long
// waves: the steps of ISO 21920-3 as pure functions; any thread. Heights are in metres and equally
// spaced; NaN marks a point that was not measured. Each row of a topography is processed by itself,
// because each is a line of the model.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/fourier.h"
#include "core/measured/processing_choices.h"

namespace asperity {

std::int64_t gapCount(std::span<const double> heights);

/// Returns the mean of the heights that were measured; 0 where there are none.
double meanHeight(std::span<const double> heights);

/// Marks outliers as gaps and returns their number. An outlier is farther from the form, which is
/// fitted to all other heights, than `multiples` times the median deviation of the others from it.
/// The function marks nothing where more than half of all heights lie on the form exactly.
std::int64_t markOutliers(std::span<double> heights, double multiples, FormRemoval form);

/// The usual limit of outliers, in median deviations: `surface.outliers=6`.
inline constexpr double kUsualOutliers = 6;

/// Returns how many points of a row are spikes, as measuring instruments make them: groups of at
/// most three outliers at the usual limit whose steps from both measured neighbours, in the same
/// direction, are larger than that limit and than ten median steps of the row. Rough surfaces reach
/// beyond the limit as well, but by steps of the usual size; heights without any correlation do not
/// make steps as large as ten median ones if they are Gaussian. Of a skewed surface with a Hurst
/// exponent of 0.3, about one point of 1000 is counted.
std::int64_t spikeCount(std::span<const double> heights, FormRemoval form);

/// Fills gaps by straight lines between their neighbours; before the first and after the last
/// measured point the height is constant. At least one point must have been measured.
void interpolateGaps(std::span<double> heights);

/// Subtracts the form by least squares: the mean, a straight line or a parabola. There must be no
/// gaps.
void removeForm(std::span<double> heights, FormRemoval form);

/// Subtracts the form of a whole topography: the mean, a plane or a paraboloid a + b x + c y + d
/// x^2 + e x y + f y^2. heights: rows x columns, row by row, without gaps.
void removeForm(std::span<double> heights, std::size_t rows, std::size_t columns, FormRemoval form);

/// The Gaussian profile filter of ISO 16610-21. Its weights are exp(-pi (x / (alpha lambda))^2)
/// with alpha = sqrt(ln 2 / pi), so that half of the amplitude of a sine of the cut-off wavelength
/// passes. Near the ends, where a part of the weights lies outside of the profile, the mean line is
/// the straight line that is fitted with the remaining weights (ISO 16610-31 of first order without
/// robustness): a straight profile passes unchanged up to its ends. Elsewhere both definitions
/// agree.
class GaussianFilter {
 public:
  /// spacing and cutOff: m; the cut-off is at least twice the spacing. With fewer than five points
  /// per cut-off wavelength the sampled weights let a little more than half of the amplitude pass.
  GaussianFilter(std::size_t points, double spacing, double cutOff);

  /// Returns the waves that are longer than the cut-off. heights: as many as `points`, without
  /// gaps.
  std::vector<double> meanLine(std::span<const double> heights) const;

 private:
  std::size_t points_;
  RealTransform transform_;
  std::vector<std::complex<double>> weights_, moments_;  // transforms of s(x) and of x s(x)
  std::vector<double> ofHeight_, ofMoment_;  // the mean line is ofHeight T_0 + ofMoment T_1
};

}  // namespace asperity
