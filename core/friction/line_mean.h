// The mean of a number over lines, and its standard error. Random lines are independent. Rows of a
// topography are not: neighbouring rows are nearly the same line, so their mean is less certain
// than that of as many independent lines. Plain values; one thread at a time.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/statistics.h"

namespace asperity {

/// Mean and variance of a stream of numbers (Welford's recurrence).
class RunningMean {
 public:
  void add(double value) {
    ++count_;
    const double step = value - mean_;
    mean_ += step / static_cast<double>(count_);
    squares_ += step * (value - mean_);
  }
  /// Adds all numbers of another stream (Chan, Golub and LeVeque 1983).
  void add(const RunningMean& other) {
    if (other.count_ == 0) return;
    const std::int64_t all = count_ + other.count_;
    const double part = static_cast<double>(other.count_) / static_cast<double>(all);
    const double step = other.mean_ - mean_;
    squares_ += other.squares_ + step * step * part * static_cast<double>(count_);
    mean_ += step * part;
    count_ = all;
  }
  double mean() const { return count_ > 0 ? mean_ : kNaN; }
  /// Returns the variance of one number, with n - 1; needs two.
  double variance() const { return count_ > 1 ? squares_ / static_cast<double>(count_ - 1) : kNaN; }
  /// Returns the standard error of the mean of independent numbers; needs two.
  double standardError() const { return std::sqrt(variance() / static_cast<double>(count_)); }
  std::int64_t count() const { return count_; }

 private:
  std::int64_t count_ = 0;
  double mean_ = 0, squares_ = 0;
};

/// The standard error of a mean, and its degrees of freedom: n - 1 for n independent numbers.
struct MeanError {
  double standardError = kNaN;
  double degreesOfFreedom = 0;
};

/// Returns the error of the mean of numbers along a line, such as friction of row after row of a
/// topography, from their autocovariances c_k:
///
///   error^2 = V = (c_0 + 2 sum_k c_k) / n,
///
/// where the sum ends by the rule of Geyer (Statist. Sci. 7, 473, 1992): sums of two neighbouring
/// c_k are taken as long as they are positive, none larger than the one before (the initial
/// monotone sequence). Deviations are counted from the mean of the same numbers, so that each c_k
/// is too small by V (1 - k / n). That is added, which lengthens the sum, until V agrees with
/// itself. The error has n / w degrees of freedom where w lags are summed, counted on both sides
/// (Bartlett: the relative variance of such a sum is 2 w / n).
///
/// It is the error of the mean over one piece of an endless surface whose statistics are the same
/// everywhere. What is common to all numbers, such as a height that differs from piece to piece,
/// does not show in them.
///
/// Numbers whose c_1 is smaller than twice its standard error, c_0 / sqrt(n), count as independent
/// and have the usual error. Needs two numbers.
MeanError errorOfCorrelatedMean(std::span<const double> values);

/// The degrees of freedom below which a standard error is too uncertain to rely on: fewer than
/// about ten independent groups of rows.
inline constexpr double kFewDegreesOfFreedom = 9;

/// The mean over lines: independent ones, or the rows of a topography in their order.
class LineMean {
 public:
  LineMean() = default;
  /// orderedRows: LineSource::orderedRows(); 0 for independent lines. Lines after that number
  /// repeat rows and add no information about the surface.
  explicit LineMean(std::int64_t orderedRows) : orderedRows_(orderedRows) {}

  void add(double value) {
    all_.add(value);
    if (static_cast<std::int64_t>(rows_.size()) < orderedRows_) rows_.push_back(value);
  }
  double mean() const { return all_.mean(); }
  std::int64_t count() const { return all_.count(); }
  MeanError error() const {
    if (orderedRows_ > 0) return errorOfCorrelatedMean(rows_);
    return {all_.standardError(), static_cast<double>(all_.count() - 1)};
  }

 private:
  RunningMean all_;
  std::int64_t orderedRows_ = 0;
  std::vector<double> rows_;
};

/// Returns the error of the mean of numbers, one for each line.
MeanError lineMeanError(std::span<const double> values, std::int64_t orderedRows);

}  // namespace asperity
