// The values that a slider can take: a rising list of round numbers, so that every step of the
// slider is another value and whole numbers stay whole. Plain value; any thread.
#pragma once

#include <vector>

#include "core/scene/parameters.h"

namespace asperity {

class SliderScale {
 public:
  /// For a row with a RealField or an IntegerField.
  explicit SliderScale(const Parameter& parameter);

  int count() const { return static_cast<int>(values_.size()); }
  double valueAt(int position) const;

  /// The position whose value is nearest, on the row's own scale.
  int positionOf(double value) const;

 private:
  double coordinate(double value) const;

  Scale scale_ = Scale::Linear;
  std::vector<double> values_;
};

}  // namespace asperity
