// Profile parameters of ISO 21920-2: what people read off a roughness instrument. Pure functions;
// any thread. Heights in metres, equally spaced; NaN marks a point that was not measured and is
// left out.
#pragma once

#include <span>

namespace asperity {

/// Named as P parameters; of a profile without its long waves they are R parameters. All heights
/// count from the mean.
struct ProfileParameters {
  double length = 0;  // m, evaluation length
  double pa = 0;      // m, arithmetic mean height, mean of |z|
  double pq = 0;      // m, root mean square height
  double psk = 0;     // skewness, mean of z^3 over Pq^3; NaN where Pq is 0
  double pku = 0;     // kurtosis, mean of z^4 over Pq^4; likewise
  double pz = 0;      // m, maximum height: highest peak to deepest valley, mean over the sections
  double pt = 0;      // m, the same of the whole length
  double pdq = 0;     // root mean square slope, by seven points; by two of fewer; NaN
                      // where no so many neighbours were measured
};

/// sectionLength: m, over which each maximum height is taken (for R parameters the cut-off
/// wavelength); 0: one section, as for P parameters.
ProfileParameters profileParameters(std::span<const double> heights, double spacing,
                                    double sectionLength = 0);

}  // namespace asperity
