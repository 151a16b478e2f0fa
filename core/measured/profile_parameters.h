// Profile parameters of ISO 21920-2, as roughness instruments show them. Pure functions; any
// thread. Heights are in metres and equally spaced; NaN marks a point that was not measured and is
// left out.
#pragma once

#include <span>

namespace asperity {

/// The parameters have the names of P parameters; those of a profile without its long waves are R
/// parameters. All heights are measured from the mean.
struct ProfileParameters {
  double length = 0;  // m, evaluation length
  double pa = 0;      // m, arithmetic mean height, mean of |z|
  double pq = 0;      // m, root mean square height
  double psk = 0;     // skewness, mean of z^3 over Pq^3; NaN where Pq is 0
  double pku = 0;     // kurtosis, mean of z^4 over Pq^4; likewise
  double pz = 0;      // m, maximum height: highest peak to deepest valley, mean over the sections
  double pt = 0;      // m, the same of the whole length
  double pdq = 0;     // rms slope, by seven points, or by two in a profile with fewer points; NaN
                      // where too few neighbouring points were measured
};

/// sectionLength: m, the length over which each maximum height is determined (the cut-off
/// wavelength for R parameters); 0: one section, as for P parameters.
ProfileParameters profileParameters(std::span<const double> heights, double spacing,
                                    double sectionLength = 0);

}  // namespace asperity
