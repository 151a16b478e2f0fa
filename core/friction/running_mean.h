// Mean and spread of a stream of numbers (Welford's recurrence). A plain value; one thread at a
// time.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/friction/curve_point.h"

namespace asperity {

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
  double mean() const { return count_ > 0 ? mean_ : kNotApplicable; }
  /// Of one number, with n - 1; needs two.
  double variance() const {
    return count_ > 1 ? squares_ / static_cast<double>(count_ - 1) : kNotApplicable;
  }
  /// Of the mean; needs two.
  double standardError() const { return std::sqrt(variance() / static_cast<double>(count_)); }
  std::int64_t count() const { return count_; }

 private:
  std::int64_t count_ = 0;
  double mean_ = 0, squares_ = 0;
};

}  // namespace asperity
