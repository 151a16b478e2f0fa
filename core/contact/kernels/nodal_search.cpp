#include "core/contact/kernels/nodal_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr int kMostLooks = 400;
constexpr int kLooksBeforeZero = 12;
constexpr double kRounding = 1e-14;  // relative; depths closer than this are one edge

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

}  // namespace

void NodalSearch::start(double load, double spacing, double upper, double guess) {
  *this = {};
  load_ = load;
  spacing_ = spacing;
  upperBound_ = upper;
  lower_.depth = -std::numeric_limits<double>::min();  // nothing touches
  ask(Stage::Bracket, guess > 0 && guess < upper ? guess : upper);
}

void NodalSearch::ask(Stage stage, double depth) {
  stage_ = stage;
  next_ = depth;
}

void NodalSearch::take(const NodalLook& look) {
  ++passes_;
  switch (stage_) {
    case Stage::Bracket:
      return takeBracket(look);
    case Stage::Narrow:
      return takeNarrow(look);
    case Stage::Threshold:
      return takeThreshold(look);
    case Stage::Above:
      return takeAbove(look);
    case Stage::Below:
      return takeBelow(look);
    case Stage::Answer:
      return takeAnswer(look);
    case Stage::Done:
      return;
  }
}

void NodalSearch::takeBracket(const NodalLook& look) {
  if (isEnough(look)) {
    upper_ = look;
    return chooseNext();
  }
  lower_ = look;
  if (look.depth >= upperBound_) upperBound_ *= 2;
  ask(Stage::Bracket, std::min(1.25 * look.depth, upperBound_));
}

void NodalSearch::takeNarrow(const NodalLook& look) {
  const bool enough = isEnough(look);
  sameSide_ = enough == lastWasEnough_ ? sameSide_ + 1 : 0;
  lastWasEnough_ = enough;
  (enough ? upper_ : lower_) = look;
  chooseNext();
}

/// The secant's point, kept off the ends that do not move, inside what both straight pieces allow.
double NodalSearch::pointInside() const {
  double low = lower_.depth, high = upper_.depth;
  // Going down from above elements are only lost, going up from below they only join.
  if (upper_.loaded > 0) low = std::max(low, high - (upper_.force - load_) / stiffness(upper_));
  if (lower_.loaded > 0)
    high = std::min(high, lower_.depth + (load_ - lower_.force) / stiffness(lower_));
  const double part = (load_ - lower_.force) / (upper_.force - lower_.force);
  double point = lower_.depth + part * (upper_.depth - lower_.depth);
  if (sameSide_ > 1 || !(point > low && point < high)) point = 0.5 * (low + high);
  if (!(point > lower_.depth && point < upper_.depth)) point = 0.5 * (lower_.depth + upper_.depth);
  return point;
}

void NodalSearch::chooseNext() {
  const double differing = upper_.loaded - lower_.loaded;
  if (differing == 0 && passes_ < kMostLooks)
    return ask(Stage::Answer, upper_.depth - (upper_.force - load_) / stiffness(upper_));
  // Neighbouring numbers, but for rounding: what enters between them is on the edge.
  const bool neighbours = upper_.depth - lower_.depth <= kRounding * upper_.depth;
  if (neighbours || upper_.depth <= 0 || passes_ >= kMostLooks) return askAround(upper_.depth);
  // Elements on the lowest level of the line are loaded at any depth: there is nothing to narrow.
  if (lower_.depth < 0 && passes_ >= kLooksBeforeZero) return ask(Stage::Narrow, 0);
  if (halving_) return ask(Stage::Narrow, 0.5 * (lower_.depth + upper_.depth));
  if (differing == 1) return ask(Stage::Threshold, upper_.depth);
  ask(Stage::Narrow, pointInside());
}

void NodalSearch::takeThreshold(const NodalLook& look) {
  upper_ = look;
  const double edge = look.threshold;
  const double slack = kRounding * look.depth;
  if (!(edge > lower_.depth - slack && edge <= look.depth + slack)) return halve();
  const double straight = look.depth - (look.force - load_) / stiffness(look);
  if (straight >= edge) return ask(Stage::Answer, straight);
  const double missing = load_ - lower_.force - stiffness(lower_) * (edge - lower_.depth);
  if (missing > 0) return askAround(edge);
  ask(Stage::Answer, lower_.depth + (load_ - lower_.force) / stiffness(lower_));
}

/// Where elements hardly relax from one to the next, a threshold loses its digits: from now on the
/// bracket is halved down to neighbouring numbers.
void NodalSearch::halve() {
  halving_ = true;
  chooseNext();
}

/// Whether an element touches at its very threshold is a matter of rounding, and in lanes even of
/// its neighbours: looks a little above and a little below. Where these do not differ the threshold
/// was wrong; between neighbouring numbers there is nothing better, and the looks move apart.
void NodalSearch::askAround(double edge) {
  edge_ = edge;
  reach_ = kRounding;
  ask(Stage::Above, edge_ * (1 + reach_));
}

void NodalSearch::takeAbove(const NodalLook& look) {
  above_ = look;
  if (!isEnough(look) && passes_ < kMostLooks) {
    if (!halving_ && look.depth < upper_.depth) {
      lower_ = look;
      return halve();
    }
    reach_ *= 8;
    // At an edge of 0, of an element that touches without any depth, all its multiples are 0.
    return ask(Stage::Above, edge_ > 0 ? edge_ * (1 + reach_) : reach_ * upperBound_);
  }
  if (edge_ <= 0) return finishBetween({}, above_);
  ask(Stage::Below, edge_ * (1 - reach_));
}

void NodalSearch::takeBelow(const NodalLook& look) {
  if (!isEnough(look) || passes_ >= kMostLooks) return finishBetween(look, above_);
  if (!halving_ && look.depth > lower_.depth) {
    upper_ = look;
    return halve();
  }
  reach_ = std::min(8 * reach_, 1.0);
  ask(Stage::Below, edge_ * (1 - reach_));
}

void NodalSearch::takeAnswer(const NodalLook& look) {
  const double residual = std::abs(look.force - load_) / load_;
  if (residual > kAcceptedResidual && passes_ < kMostLooks) {
    // On the straight piece it was looked for on, neighbouring depths are too far apart for this
    // load: the answer lies between two of them.
    if (look.loaded == upper_.loaded || look.loaded == lower_.loaded) return askAround(look.depth);
    (isEnough(look) ? upper_ : lower_) = look;
    return ask(Stage::Narrow, 0.5 * (lower_.depth + upper_.depth));
  }
  answer_.balance = {look.depth, passes_, residual};
  answer_.state.sums = look.sums;
  answer_.marginalShare = 1;
  stage_ = Stage::Done;
}

void NodalSearch::finishBetween(const NodalLook& less, const NodalLook& more) {
  const bool rises = more.force > less.force;
  const double share = rises ? (load_ - less.force) / (more.force - less.force) : 1;
  const bool inside = rises && share >= 0 && share <= 1;  // not so only where passes ran out
  answer_.state.sums = blend(less.sums, more.sums, share);
  answer_.balance = {edge_, passes_,
                     inside ? std::abs(answer_.state.sums.pressure - load_) / load_
                            : std::numeric_limits<double>::infinity()};
  answer_.marginalShare = more.loaded > less.loaded ? share : 1;
  stage_ = Stage::Done;
}

}  // namespace asperity
