#include "core/contact/kernels/nodal_balance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr int kMaxNodalPasses = 400;
constexpr int kPassesBeforeZero = 12;
constexpr double kRoundingOfDepth = 1e-14;  // relative; closer depths are one edge

/// Returns the combination with this share of `upper` and the rest of `lower`.
PassSums blend(const PassSums& lower, const PassSums& upper, double share) {
  PassSums sums;
  for (double PassSums::*member :
       {&PassSums::depth, &PassSums::stiffness, &PassSums::pressure, &PassSums::work,
        &PassSums::dissipation, &PassSums::contactLength, &PassSums::slopeSquared, &PassSums::gaps})
    sums.*member = lower.*member + share * (upper.*member - lower.*member);
  return sums;
}

/// One balance, whose caller runs the passes, so that many balances share them. Plain value; no
/// allocation.
class NodalSearch {
 public:
  /// load = F_N / 4G (m^2); guess: a depth near the answer (m), or 0.
  void start(const PreparedProfile& line, double load, double guess);

  bool isDone() const { return stage_ == Stage::Done; }
  /// Return the depth (m) of the next pass, and what it has to compute.
  double nextDepth() const { return next_; }
  Output wanted() const { return stage_ >= Stage::Threshold ? Output::Everything : Output::Force; }
  /// Takes the result of that pass.
  void take(const NodalState& found);

  const NodalBalance& answer() const { return answer_; }

 private:
  enum class Stage { Bracket, Narrow, Threshold, Above, Below, Answer, Done };

  void takeBracket(const NodalState& found);
  void takeNarrow(const NodalState& found);
  void takeThreshold(const NodalState& found);
  void takeAbove(const NodalState& found);
  void takeBelow(const NodalState& found);
  void takeAnswer(const NodalState& found);
  void chooseNext();
  double pointInside() const;
  void halve();
  void askAround(double edge);
  void ask(Stage stage, double depth);
  void finishBetween(const NodalState& less, const NodalState& more);
  bool isEnough(const NodalState& state) const { return state.sums.pressure >= load_; }
  /// Returns the depth at which the straight piece through a state carries the load.
  double straightTo(const NodalState& state) const {
    return state.depth - (state.sums.pressure - load_) / stiffness(state);
  }
  double stiffness(const NodalState& state) const { return state.loaded * spacing_; }

  double load_ = 0, spacing_ = 0, upperBound_ = 0, next_ = 0;
  NodalState lower_, upper_;  // too little force, enough force
  NodalState above_;          // at the threshold of the element that enters last
  double edge_ = 0;           // m, its indentation
  double reach_ = 0;          // relative distance of the passes from it
  int passes_ = 0, sameSide_ = 0;
  bool lastWasEnough_ = false, halving_ = false;
  Stage stage_ = Stage::Done;
  NodalBalance answer_;
};

void NodalSearch::start(const PreparedProfile& line, double load, double guess) {
  *this = {};
  load_ = load;
  spacing_ = line.spacing;
  // Complete contact at rest is a usual upper bound; otherwise the bracket grows.
  upperBound_ = load / line.length + line.meanHeight;
  lower_.depth = -std::numeric_limits<double>::min();  // nothing touches
  ask(Stage::Bracket, guess > 0 && guess < upperBound_ ? guess : upperBound_);
}

void NodalSearch::ask(Stage stage, double depth) {
  stage_ = stage;
  next_ = depth;
}

void NodalSearch::take(const NodalState& found) {
  ++passes_;
  switch (stage_) {
    case Stage::Bracket:
      return takeBracket(found);
    case Stage::Narrow:
      return takeNarrow(found);
    case Stage::Threshold:
      return takeThreshold(found);
    case Stage::Above:
      return takeAbove(found);
    case Stage::Below:
      return takeBelow(found);
    case Stage::Answer:
      return takeAnswer(found);
    case Stage::Done:
      return;
  }
}

void NodalSearch::takeBracket(const NodalState& found) {
  if (isEnough(found)) {
    upper_ = found;
    return chooseNext();
  }
  lower_ = found;
  if (found.depth >= upperBound_) upperBound_ *= 2;
  ask(Stage::Bracket, std::min(1.25 * found.depth, upperBound_));
}

void NodalSearch::takeNarrow(const NodalState& found) {
  const bool enough = isEnough(found);
  sameSide_ = enough == lastWasEnough_ ? sameSide_ + 1 : 0;
  lastWasEnough_ = enough;
  (enough ? upper_ : lower_) = found;
  chooseNext();
}

/// Returns the secant's point, kept away from ends that do not move, inside the limits of both
/// straight pieces.
double NodalSearch::pointInside() const {
  double low = lower_.depth, high = upper_.depth;
  // With decreasing depth elements only leave; with increasing depth they only join.
  if (upper_.loaded > 0) low = std::max(low, straightTo(upper_));
  if (lower_.loaded > 0) high = std::min(high, straightTo(lower_));
  const double lowerForce = lower_.sums.pressure, upperForce = upper_.sums.pressure;
  const double part = (load_ - lowerForce) / (upperForce - lowerForce);
  double point = lower_.depth + part * (upper_.depth - lower_.depth);
  if (sameSide_ > 1 || !(point > low && point < high)) point = 0.5 * (low + high);
  if (!(point > lower_.depth && point < upper_.depth)) point = 0.5 * (lower_.depth + upper_.depth);
  return point;
}

void NodalSearch::chooseNext() {
  const double differing = upper_.loaded - lower_.loaded;
  if (differing == 0 && passes_ < kMaxNodalPasses) return ask(Stage::Answer, straightTo(upper_));
  // The ends are neighbouring numbers except for rounding: the element that enters between them is
  // on the edge.
  const bool neighbours = upper_.depth - lower_.depth <= kRoundingOfDepth * upper_.depth;
  if (neighbours || upper_.depth <= 0 || passes_ >= kMaxNodalPasses) return askAround(upper_.depth);
  // Elements on the lowest level of the line are loaded at any depth: the bracket cannot shrink.
  if (lower_.depth < 0 && passes_ >= kPassesBeforeZero) return ask(Stage::Narrow, 0);
  if (halving_) return ask(Stage::Narrow, 0.5 * (lower_.depth + upper_.depth));
  if (differing == 1) return ask(Stage::Threshold, upper_.depth);
  ask(Stage::Narrow, pointInside());
}

void NodalSearch::takeThreshold(const NodalState& found) {
  upper_ = found;
  const double edge = found.threshold;
  const double slack = kRoundingOfDepth * found.depth;
  if (!(edge > lower_.depth - slack && edge <= found.depth + slack)) return halve();
  const double straight = straightTo(found);
  if (straight >= edge) return ask(Stage::Answer, straight);
  const double missing = load_ - lower_.sums.pressure - stiffness(lower_) * (edge - lower_.depth);
  if (missing > 0) return askAround(edge);
  ask(Stage::Answer, straightTo(lower_));
}

/// Switches to bisection down to neighbouring numbers: where elements hardly relax from one to the
/// next, a threshold loses its digits.
void NodalSearch::halve() {
  halving_ = true;
  chooseNext();
}

/// Requests passes around a threshold. Whether an element touches exactly there depends on
/// rounding, and in lanes its neighbours are uncertain too: one pass is a little above and one a
/// little below. If these do not differ, the threshold was wrong; between neighbouring numbers
/// nothing better exists, and the two move apart.
void NodalSearch::askAround(double edge) {
  edge_ = edge;
  reach_ = kRoundingOfDepth;
  ask(Stage::Above, edge_ * (1 + reach_));
}

void NodalSearch::takeAbove(const NodalState& found) {
  above_ = found;
  if (!isEnough(found) && passes_ < kMaxNodalPasses) {
    if (!halving_ && found.depth < upper_.depth) {
      lower_ = found;
      return halve();
    }
    reach_ *= 8;
    // An edge of 0 belongs to an element that touches without any depth; all its multiples are 0.
    return ask(Stage::Above, edge_ > 0 ? edge_ * (1 + reach_) : reach_ * upperBound_);
  }
  if (edge_ <= 0) return finishBetween({}, above_);
  ask(Stage::Below, edge_ * (1 - reach_));
}

void NodalSearch::takeBelow(const NodalState& found) {
  if (!isEnough(found) || passes_ >= kMaxNodalPasses) return finishBetween(found, above_);
  if (!halving_ && found.depth > lower_.depth) {
    upper_ = found;
    return halve();
  }
  reach_ = std::min(8 * reach_, 1.0);
  ask(Stage::Below, edge_ * (1 - reach_));
}

void NodalSearch::takeAnswer(const NodalState& found) {
  const double residual = std::abs(found.sums.pressure - load_) / load_;
  if (residual > kAcceptedResidual && passes_ < kMaxNodalPasses) {
    // On the straight piece on which the solution was searched, neighbouring depths are too far
    // apart for this load: the solution lies between two of them.
    if (found.loaded == upper_.loaded || found.loaded == lower_.loaded)
      return askAround(found.depth);
    (isEnough(found) ? upper_ : lower_) = found;
    return ask(Stage::Narrow, 0.5 * (lower_.depth + upper_.depth));
  }
  answer_.balance = {found.depth, passes_, residual};
  answer_.sums = found.sums;
  answer_.marginalShare = 1;
  stage_ = Stage::Done;
}

void NodalSearch::finishBetween(const NodalState& less, const NodalState& more) {
  const double lessForce = less.sums.pressure, moreForce = more.sums.pressure;
  const bool rises = moreForce > lessForce;
  const double share = rises ? (load_ - lessForce) / (moreForce - lessForce) : 1;
  const bool inside = rises && share >= 0 && share <= 1;  // false only where passes ran out
  answer_.sums = blend(less.sums, more.sums, share);
  answer_.balance = {edge_, passes_,
                     inside ? std::abs(answer_.sums.pressure - load_) / load_
                            : std::numeric_limits<double>::infinity()};
  answer_.marginalShare = more.loaded > less.loaded ? share : 1;
  stage_ = Stage::Done;
}

/// Runs one pass for all unfinished searches; returns false where all are finished.
bool passOnce(const PreparedProfile& line, const LaneValues& relaxationLength,
              std::span<NodalSearch> searches, LaneValues& depth,
              std::array<NodalState, kMaxLanes>& states) {
  Output output = Output::Force;
  bool goesOn = false;
  for (std::size_t lane = 0; lane < searches.size(); ++lane) {
    if (searches[lane].isDone()) continue;
    goesOn = true;
    depth[lane] = searches[lane].nextDepth();
    if (searches[lane].wanted() == Output::Everything) output = Output::Everything;
  }
  if (!goesOn) return false;
  // Lanes without a search repeat the last one.
  for (std::size_t lane = searches.size(); lane < kMaxLanes; ++lane)
    depth[lane] = depth[searches.size() - 1];
  nodalLanePass(line, depth, relaxationLength, output, states);
  for (std::size_t lane = 0; lane < searches.size(); ++lane)
    if (!searches[lane].isDone()) searches[lane].take(states[lane]);
  return true;
}

}  // namespace

NodalBalance balanceNodal(const PreparedProfile& line, double relaxationLength, double load) {
  NodalSearch search;
  search.start(line, load, 0);
  while (!search.isDone()) search.take(nodalPass(line, search.nextDepth(), relaxationLength));
  return search.answer();
}

bool balanceNodalLanes(const PreparedProfile& line, std::span<const double> relaxationLengths,
                       double load, const LaneValues& guesses, const std::stop_token& stop,
                       std::span<NodalBalance> balances) {
  const std::size_t used = relaxationLengths.size();
  LaneValues depth{}, relaxationLength{};
  std::array<NodalState, kMaxLanes> states;
  std::array<NodalSearch, kMaxLanes> searches;
  for (std::size_t lane = 0; lane < kMaxLanes; ++lane)
    relaxationLength[lane] = relaxationLengths[std::min(lane, used - 1)];
  for (std::size_t lane = 0; lane < used; ++lane) searches[lane].start(line, load, guesses[lane]);
  while (passOnce(line, relaxationLength, {searches.data(), used}, depth, states))
    if (stop.stop_requested()) return false;
  for (std::size_t lane = 0; lane < used; ++lane) balances[lane] = searches[lane].answer();
  return true;
}

}  // namespace asperity
