// A queue of one pass, for tests of the passes themselves.
#pragma once

#include <limits>
#include <vector>

#include "core/contact/kernels/pass.h"

namespace asperity {

/// A pass at one depth, cut or not, until it is told to stop at this question.
class FixedDepths : public PassQueue {
 public:
  FixedDepths(double depth, double relaxationLength, int parts = 1,
              int stopAtQuestion = std::numeric_limits<int>::max())
      : request_{depth, relaxationLength, parts}, stopAtQuestion_(stopAtQuestion) {}

  bool begin(std::size_t stream, PassRequest& request) override {
    request = request_;
    return stream == 0;
  }
  bool next(std::size_t, const PassSums& sums, PassRequest&) override {
    found.push_back(sums);
    return false;
  }
  bool isStopped() const override { return ++asked_ >= stopAtQuestion_; }
  int timesAsked() const { return asked_; }

  std::vector<PassSums> found;

 private:
  PassRequest request_;
  int stopAtQuestion_;
  mutable int asked_ = 0;
};

}  // namespace asperity
