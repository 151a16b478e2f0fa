#include "core/measured/processing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/linear_algebra.h"
#include "core/base/statistics.h"
#include "core/measured/topography.h"

namespace asperity {
namespace {

/// Returns the number of terms of the polynomial that describes the form along one direction.
int termCount(FormRemoval form) {
  return form == FormRemoval::None   ? 0
         : form == FormRemoval::Mean ? 1
         : form == FormRemoval::Line ? 2
                                     : 3;
}

/// Returns the position of point `i` of n on [-1, 1], which keeps the normal equations well
/// conditioned.
double scaledPosition(std::size_t i, std::size_t n) {
  return n > 1 ? 2 * static_cast<double>(i) / static_cast<double>(n - 1) - 1 : 0;
}

/// Fits a sum of functions by least squares; points are added one by one. Functions that the points
/// cannot distinguish get no more than they need.
template <int Terms>
class NormalEquations {
 public:
  using Vector = Eigen::Matrix<double, Terms, 1>;
  void add(const Vector& functions, double value) {
    matrix_ += functions * functions.transpose();
    right_ += functions * value;
  }
  Vector solve() const { return leastNormSolution(matrix_, right_); }

 private:
  Eigen::Matrix<double, Terms, Terms> matrix_ = Eigen::Matrix<double, Terms, Terms>::Zero();
  Vector right_ = Vector::Zero();
};

Eigen::Vector3d powers(double x, int terms) {
  return {terms > 0 ? 1.0 : 0.0, terms > 1 ? x : 0.0, terms > 2 ? x * x : 0.0};
}

/// Returns the coefficients of the form of a row, fitted to the heights that are not gaps.
Eigen::Vector3d fitForm(std::span<const double> heights, int terms) {
  NormalEquations<3> fit;
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (!std::isnan(heights[i]))
      fit.add(powers(scaledPosition(i, heights.size()), terms), heights[i]);
  return fit.solve();
}

/// How far heights lie from the form of the kept ones: the deviation of each height, and median and
/// median deviation of those of the kept ones.
struct Deviations {
  std::vector<double> each;
  double middle = 0, spread = 0;
};

Deviations deviationsFromForm(std::span<const double> heights, std::span<const double> kept,
                              int terms) {
  const Eigen::Vector3d form = fitForm(kept, terms);
  Deviations deviations{std::vector<double>(heights.size(), kMissingHeight)};
  std::vector<double> known;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (std::isnan(heights[i])) continue;
    deviations.each[i] = heights[i] - powers(scaledPosition(i, heights.size()), terms).dot(form);
    if (!std::isnan(kept[i])) known.push_back(deviations.each[i]);
  }
  deviations.middle = upperMedian(known);
  for (double& value : known) value = std::abs(value - deviations.middle);
  deviations.spread = upperMedian(std::move(known));
  return deviations;
}

/// Returns the indices of the measured points.
std::vector<std::size_t> measuredPoints(std::span<const double> heights) {
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (!std::isnan(heights[i])) points.push_back(i);
  return points;
}

}  // namespace

std::int64_t gapCount(std::span<const double> heights) {
  return std::ranges::count_if(heights, [](double height) { return std::isnan(height); });
}

double meanHeight(std::span<const double> heights) {
  double sum = 0, count = 0;
  for (const double height : heights)
    if (!std::isnan(height)) {
      sum += height;
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

std::int64_t markOutliers(std::span<double> heights, double multiples, FormRemoval form) {
  constexpr int kRounds = 20;
  if (!(multiples > 0)) return 0;
  const int terms = termCount(form);
  std::vector<double> kept(heights.begin(), heights.end());
  const std::int64_t gaps = gapCount(heights);
  if (gaps == static_cast<std::int64_t>(heights.size())) return 0;
  // Outliers distort the fit that detects them, so the fit is repeated without them until the set
  // of outliers no longer changes.
  for (int round = 0; round < kRounds; ++round) {
    const auto [deviation, middle, spread] = deviationsFromForm(heights, kept, terms);
    if (!(spread > 0)) break;
    bool hasChanged = false;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      if (std::isnan(heights[i])) continue;
      const bool isOutlier = std::abs(deviation[i] - middle) > multiples * spread;
      hasChanged |= isOutlier != std::isnan(kept[i]);
      kept[i] = isOutlier ? kMissingHeight : heights[i];
    }
    if (!hasChanged || gapCount(kept) == static_cast<std::int64_t>(kept.size())) break;
  }
  // If all heights were outliers, none of them could be told from the others.
  const std::int64_t marked = gapCount(kept) - gaps;
  if (marked + gaps == static_cast<std::int64_t>(heights.size())) return 0;
  std::ranges::copy(kept, heights.begin());
  return marked;
}

std::int64_t spikeCount(std::span<const double> heights, FormRemoval form) {
  constexpr double kOfSteps = 10;
  constexpr std::size_t kWidest = 3;
  const std::vector<std::size_t> points = measuredPoints(heights);
  if (points.size() <= kWidest) return 0;
  std::vector<double> steps;
  for (std::size_t k = 1; k < points.size(); ++k)
    steps.push_back(std::abs(heights[points[k]] - heights[points[k - 1]]));
  const double largest = *std::ranges::max_element(steps);
  const double largeStep = kOfSteps * upperMedian(std::move(steps));
  // Most rows have no such step, and are not fitted.
  if (!(largest > largeStep)) return 0;
  std::vector<double> kept(heights.begin(), heights.end());
  if (markOutliers(kept, kUsualOutliers, form) == 0) return 0;
  const double spread = deviationsFromForm(heights, kept, termCount(form)).spread;
  const double limit = std::max(kUsualOutliers * spread, largeStep);
  std::int64_t spikes = 0;
  for (std::size_t first = 0, end = 0; first < points.size(); first = end) {
    end = first + 1;
    if (!std::isnan(kept[points[first]])) continue;
    while (end < points.size() && std::isnan(kept[points[end]])) ++end;
    if (end - first > kWidest) continue;
    const bool isAtBegin = first == 0, isAtEnd = end == points.size();
    const double rise = isAtBegin ? 0 : heights[points[first]] - heights[points[first - 1]];
    const double fall = isAtEnd ? 0 : heights[points[end - 1]] - heights[points[end]];
    const double up = isAtBegin ? fall : isAtEnd ? rise : std::min(rise, fall);
    const double down = isAtBegin ? fall : isAtEnd ? rise : std::max(rise, fall);
    if (up > limit || down < -limit) spikes += static_cast<std::int64_t>(end - first);
  }
  return spikes;
}

void interpolateGaps(std::span<double> heights) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::size_t last = kNone;  // measured point so far
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (std::isnan(heights[i])) continue;
    const std::size_t first = last == kNone ? 0 : last + 1;
    for (std::size_t j = first; j < i; ++j) {
      const double part =
          last == kNone ? 1 : static_cast<double>(j - last) / static_cast<double>(i - last);
      heights[j] = last == kNone ? heights[i] : heights[last] + part * (heights[i] - heights[last]);
    }
    last = i;
  }
  if (last == kNone) return;
  for (std::size_t j = last + 1; j < heights.size(); ++j) heights[j] = heights[last];
}

void removeForm(std::span<double> heights, FormRemoval form) {
  const int terms = termCount(form);
  if (terms == 0) return;
  const Eigen::Vector3d fitted = fitForm(heights, terms);
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] -= powers(scaledPosition(i, heights.size()), terms).dot(fitted);
}

void removeForm(std::span<double> heights, std::size_t rows, std::size_t columns,
                FormRemoval form) {
  const int terms = termCount(form);
  if (terms == 0) return;
  const auto functions = [&](std::size_t row, std::size_t column) {
    const double x = scaledPosition(column, columns), y = scaledPosition(row, rows);
    const double linear = terms > 1 ? 1 : 0, square = terms > 2 ? 1 : 0;
    return Eigen::Matrix<double, 6, 1>{
        1, linear * x, linear * y, square * x * x, square * x * y, square * y * y};
  };
  NormalEquations<6> fit;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      fit.add(functions(row, column), heights[row * columns + column]);
  const Eigen::Matrix<double, 6, 1> fitted = fit.solve();
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      heights[row * columns + column] -= functions(row, column).dot(fitted);
}

namespace {

/// The weights have fallen to 1e-14 of their maximum at this distance.
constexpr double kKernelWidth = 1.5;  // cut-off wavelengths

std::size_t kernelReach(std::size_t points, double spacing, double cutOff) {
  const double reach = std::ceil(kKernelWidth * cutOff / spacing);
  return reach < static_cast<double>(points)
             ? std::max<std::size_t>(static_cast<std::size_t>(reach), 1)
             : points;
}

/// Returns the convolution of values with the kernel of this transform; both are padded to the
/// transform's number of points.
std::vector<double> convolved(const RealTransform& transform, std::span<const double> values,
                              std::span<const std::complex<double>> kernel) {
  std::vector<double> padded(transform.points());
  std::ranges::copy(values, padded.begin());
  std::vector<std::complex<double>> modes = transform.forward(padded);
  for (std::size_t k = 0; k < modes.size(); ++k)
    modes[k] *= kernel[k] / static_cast<double>(transform.points());
  std::vector<double> sums = transform.backward(std::move(modes));
  sums.resize(values.size());
  return sums;
}

}  // namespace

GaussianFilter::GaussianFilter(std::size_t points, double spacing, double cutOff)
    : points_(points),
      transform_(fastTransformSize(points + kernelReach(points, spacing, cutOff))) {
  const std::size_t reach = kernelReach(points, spacing, cutOff), size = transform_.points();
  const double alpha = std::sqrt(std::numbers::ln2 / std::numbers::pi);
  std::vector<double> weight(size), moment(size), square(size);
  double sum = 0;
  // T_m(i) = sum over j of s(j) j^m z(i + j); a convolution reverses its kernel.
  for (std::size_t j = 0; j <= reach; ++j) {
    const double x = static_cast<double>(j), part = x * spacing / (alpha * cutOff);
    const double s = std::exp(-std::numbers::pi * part * part);
    sum += j == 0 ? s : 2 * s;
    for (const std::size_t index : {(size - j) % size, j}) {
      const double signedX = index == j ? -x : x;
      weight[index] = s;
      moment[index] = s * signedX;
      square[index] = s * x * x;
    }
  }
  for (std::vector<double>* kernel : {&weight, &moment, &square})
    for (double& value : *kernel) value /= sum;
  weights_ = transform_.forward(weight);
  moments_ = transform_.forward(moment);
  const std::vector<double> ones(points, 1.0);
  const std::vector<double> s0 = convolved(transform_, ones, weights_);
  const std::vector<double> s1 = convolved(transform_, ones, moments_);
  const std::vector<double> s2 = convolved(transform_, ones, transform_.forward(square));
  for (std::size_t i = 0; i < points; ++i) {
    const double determinant = s0[i] * s2[i] - s1[i] * s1[i];
    const bool isLine = determinant > 1e-12 * s0[i] * s2[i];
    ofHeight_.push_back(isLine ? s2[i] / determinant : 1 / s0[i]);
    ofMoment_.push_back(isLine ? -s1[i] / determinant : 0);
  }
}

std::vector<double> GaussianFilter::meanLine(std::span<const double> heights) const {
  std::vector<double> line = convolved(transform_, heights, weights_);
  const std::vector<double> moment = convolved(transform_, heights, moments_);
  for (std::size_t i = 0; i < points_; ++i)
    line[i] = ofHeight_[i] * line[i] + ofMoment_[i] * moment[i];
  return line;
}

}  // namespace asperity
