#include "core/contact/kernels/nodal_pass.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

class NodalPass {
 public:
  NodalPass(const PreparedProfile& line, double depth, double memory, NodeShape* shape)
      : line_(line),
        depth_(depth),
        memory_(memory),
        spacing_(line.spacing),
        lost_(memory > 0 ? -std::expm1(-line.spacing / memory) : 1),
        shape_(shape) {}

  NodalState run() {
    if (depth_ < 0) return empty();
    state_.threshold = -1;
    surface_ = depth_;  // the lowest node comes first: nothing reaches deeper
    for (std::size_t i = 0; i < line_.segments(); ++i) node(i);
    closeArc(depth_);
    return state_;
  }

 private:
  NodalState empty() {
    if (shape_) {
      shape_->depth.assign(line_.segments(), 0);
      shape_->pressure.assign(line_.segments(), 0);
    }
    return state_;
  }

  void node(std::size_t i) {
    // As heights, element and surface are told apart however far the indentation is above them.
    const bool touching = line_.rise[i] <= surface_;
    double pressure = 0;
    if (touching) {
      pressure = depth_ - line_.rise[i] - memory_ * line_.slopeIn[i];
      closeArc(depth_ - surface_);
      if (pressure > 0) load(i, pressure);
      lastTouch_ = i;
      lostSinceTouch_ = 0;
    }
    const double height = touching ? line_.rise[i] : surface_;
    const double here = std::max(depth_ - height, 0.0);  // rounding may come out above
    state_.sums.depth += here * spacing_;
    if (shape_) {
      shape_->depth.push_back(here);
      shape_->pressure.push_back(std::max(pressure, 0.0));
    }
    if (touching) arcStart_ = here;
    surface_ = height + (depth_ - height) * lost_;
    lostSinceTouch_ += (1 - lostSinceTouch_) * lost_;
  }

  /// An element carries load: Eqs. (2) to (4).
  void load(std::size_t i, double pressure) {
    const double slope = -line_.slopeIn[i];  // w' = z'
    StateSums& sums = state_.sums;
    sums.stiffness += spacing_;
    state_.loaded += 1;
    sums.pressure += pressure * spacing_;
    sums.work += pressure * slope * spacing_;
    sums.dissipation += memory_ * slope * slope * spacing_;
    sums.contactLength += spacing_;
    sums.slopeSquared += slope * slope * spacing_;
    sums.absoluteSlope += std::abs(slope) * spacing_;
    state_.threshold = std::max(state_.threshold, thresholdOf(i));
  }

  /// The indentation at which this element is reached by the line and pressed.
  double thresholdOf(std::size_t i) const {
    const double pressed = line_.rise[i] + memory_ * line_.slopeIn[i];
    double reached = 0;
    if (i > 0 && lostSinceTouch_ > 0)
      reached = line_.rise[lastTouch_] + (line_.rise[i] - line_.rise[lastTouch_]) / lostSinceTouch_;
    return std::max({pressed, reached, 0.0});
  }

  /// Energy given off since the last element that touched: from depth arcStart_ to `end`.
  void closeArc(double end) {
    state_.sums.dissipation += 0.5 * std::max(arcStart_ * arcStart_ - end * end, 0.0);
    arcStart_ = 0;
  }

  const PreparedProfile& line_;
  double depth_, memory_, spacing_, lost_;
  NodeShape* shape_;
  NodalState state_;
  double surface_ = 0;  // m, height of what reaches the next node without contact
  double arcStart_ = 0, lostSinceTouch_ = 0;
  std::size_t lastTouch_ = 0;
};

}  // namespace

NodalState nodalStateAt(const PreparedProfile& line, double depth, double memoryLength,
                        NodeShape* shape) {
  return NodalPass(line, depth, memoryLength, shape).run();
}

}  // namespace asperity
