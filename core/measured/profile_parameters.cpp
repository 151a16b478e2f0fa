#include "core/measured/profile_parameters.h"

#include <algorithm>
#include <cmath>

#include "core/base/intervals.h"
#include "core/base/statistics.h"
#include "core/measured/processing.h"

namespace asperity {
namespace {

/// Returns the difference of the highest and the lowest measured height; NaN where there is none.
double heightRange(std::span<const double> heights) {
  const Extent extent = extentOf(heights);
  return extent.isEmpty() ? kNaN : extent.size();
}

double meanRange(std::span<const double> heights, std::size_t section) {
  double sum = 0;
  int count = 0;
  for (std::size_t first = 0; first + section <= heights.size(); first += section) {
    const double range = heightRange(heights.subspan(first, section));
    if (std::isnan(range)) continue;
    sum += range;
    ++count;
  }
  return count > 0 ? sum / count : heightRange(heights);
}

/// Returns the slope times the spacing at point i by the seven-point formula of ISO 4287 and ISO
/// 21920-2.
double sevenPointStep(const double* at) {
  return (at[3] - 9 * at[2] + 45 * at[1] - 45 * at[-1] + 9 * at[-2] - at[-3]) / 60;
}

double sevenPointRmsSlope(std::span<const double> heights, double spacing) {
  const std::size_t reach = heights.size() >= 7 ? 3 : 0;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = reach; i + std::max<std::size_t>(reach, 1) < heights.size(); ++i) {
    const auto around = heights.subspan(i - reach, reach > 0 ? 7 : 2);
    if (std::ranges::any_of(around, [](double height) { return std::isnan(height); })) continue;
    const double step = reach > 0 ? sevenPointStep(&heights[i]) : around[1] - around[0];
    sum += step * step;
    ++count;
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) / spacing : kNaN;
}

}  // namespace

ProfileParameters profileParameters(std::span<const double> heights, double spacing,
                                    double sectionLength) {
  ProfileParameters values;
  values.length = static_cast<double>(heights.size()) * spacing;
  const double count = static_cast<double>(std::ssize(heights) - gapCount(heights));
  if (count == 0) return values;
  const double mean = meanHeight(heights);
  double absolute = 0, square = 0, cube = 0, fourth = 0;
  for (const double height : heights) {
    if (std::isnan(height)) continue;
    const double z = height - mean;
    absolute += std::abs(z);
    square += z * z;
    cube += z * z * z;
    fourth += z * z * z * z;
  }
  values.pa = absolute / count;
  values.pq = std::sqrt(square / count);
  const double pq = values.pq;
  values.psk = pq > 0 ? cube / count / (pq * pq * pq) : kNaN;
  values.pku = pq > 0 ? fourth / count / (pq * pq * pq * pq) : kNaN;
  values.pt = heightRange(heights);
  const double section = std::floor(sectionLength / spacing * (1 + 1e-9));
  values.pz = section >= 2 && section < static_cast<double>(heights.size())
                  ? meanRange(heights, static_cast<std::size_t>(section))
                  : values.pt;
  values.pdq = sevenPointRmsSlope(heights, spacing);
  return values;
}

}  // namespace asperity
