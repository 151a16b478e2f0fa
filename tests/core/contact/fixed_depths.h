// A queue of one pass, for tests of the passes themselves.
#pragma once

#include <limits>
#include <vector>

#include "core/contact/kernels/pass_queue.h"

namespace asperity {

/// A pass at one depth, cut or not, until it is told to stop at the looks-th question.
class FixedDepths : public PassQueue {
 public:
  FixedDepths(double depth, double memory, int parts = 1,
              int segmentsInspected = std::numeric_limits<int>::max())
      : task_{depth, memory, parts}, looks_(segmentsInspected) {}

  bool begin(std::size_t stream, PassRequest& task) override {
    task = task_;
    return stream == 0;
  }
  bool next(std::size_t, const PassSums& sums, PassRequest&) override {
    found.push_back(sums);
    return false;
  }
  bool isStopped() const override { return ++asked_ >= looks_; }
  int timesAsked() const { return asked_; }

  std::vector<PassSums> found;

 private:
  PassRequest task_;
  int looks_;
  mutable int asked_ = 0;
};

}  // namespace asperity
