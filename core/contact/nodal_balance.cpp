#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contact/force_balance.h"

namespace asperity {
namespace {

constexpr int kMostRounds = 400;

/// share of `upper`, the rest of `lower`.
StateSums blend(const StateSums& lower, const StateSums& upper, double share) {
  StateSums sums;
  for (double StateSums::*member :
       {&StateSums::depth, &StateSums::stiffness, &StateSums::pressure, &StateSums::work,
        &StateSums::dissipation, &StateSums::contactLength, &StateSums::slopeSquared,
        &StateSums::absoluteSlope})
    sums.*member = lower.*member + share * (upper.*member - lower.*member);
  return sums;
}

/// The rising staircase F_N(d), bracketed by a depth with too little force and one with enough.
class Staircase {
 public:
  Staircase(const TravelLine& line, double memory, double load)
      : line_(line), memory_(memory), load_(load) {
    lower_ = {-std::numeric_limits<double>::min(), {}};  // nothing touches above the lowest point
    double depth = load / line.length + line.meanRise;
    while (!isEnough(upper_ = at(depth)) && rounds_ < kMostRounds) depth *= 2;
  }

  NodalBalance solve() {
    while (rounds_ < kMostRounds) {
      if (onLinearPiece()) return answer_;
      if (narrow(upper_.state.threshold)) narrow(below(upper_.depth));
      const double middle = 0.5 * (lower_.depth + upper_.depth);
      if (middle <= lower_.depth || middle >= upper_.depth) break;
      narrow(middle);
    }
    return onEdge();
  }

 private:
  struct Step {
    double depth = 0;
    NodalState state;
  };

  static double below(double depth) {
    return depth > 0 ? std::nextafter(depth, 0.0) : -std::numeric_limits<double>::min();
  }
  Step at(double depth) {
    ++rounds_;
    return {depth, nodalStateAt(line_, depth, memory_)};
  }
  bool isEnough(const Step& step) const { return step.state.sums.pressure >= load_; }

  /// Takes the depth into the bracket; true where it became its upper end.
  bool narrow(double depth) {
    if (depth <= lower_.depth || depth >= upper_.depth) return depth == upper_.depth;
    const Step step = at(depth);
    const bool enough = isEnough(step);
    (enough ? upper_ : lower_) = step;
    return enough;
  }

  /// Below the upper end the force is linear as long as every loaded element stays loaded.
  bool onLinearPiece() {
    const StateSums& sums = upper_.state.sums;
    const double depth = upper_.depth - (sums.pressure - load_) / sums.stiffness;
    if (!(depth >= upper_.state.threshold)) return false;
    const Step step = at(depth);
    finish(step.depth, step.state.sums, 1);
    return answer_.balance.isMet();
  }

  /// The ends of the bracket are neighbours: the element that enters between them carries a part.
  NodalBalance onEdge() {
    const StateSums &less = lower_.state.sums, &more = upper_.state.sums;
    const double share = (load_ - less.pressure) / (more.pressure - less.pressure);
    finish(upper_.depth, blend(less, more, share), share);
    return answer_;
  }

  void finish(double depth, const StateSums& sums, double share) {
    answer_.balance = {depth, rounds_, std::abs(sums.pressure - load_) / load_};
    answer_.state.sums = sums;
    answer_.marginalShare = share;
  }

  const TravelLine& line_;
  double memory_, load_;
  Step lower_, upper_;
  NodalBalance answer_;
  int rounds_ = 0;
};

}  // namespace

NodalBalance balanceNodal(const TravelLine& line, double memoryLength, double load) {
  return Staircase(line, memoryLength, load).solve();
}

}  // namespace asperity
