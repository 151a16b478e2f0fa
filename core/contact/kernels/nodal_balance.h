// The indentation at which the paper's separate elements carry a given force. F_N(d) is a rising
// staircase of straight pieces: loaded elements only join as d grows, so two depths with the same
// number of loaded elements have the same ones, and between them F_N is straight. Where the numbers
// differ by one, the threshold of that element determines the solution. Where the target falls into
// a jump, the entering element is partly loaded: the solution is the combination of the two states
// that carries the force exactly.
#pragma once

#include <span>
#include <stop_token>

#include "core/contact/force_balance.h"
#include "core/contact/kernels/kernels.h"

namespace asperity {

struct NodalBalance {
  Balance balance;
  PassSums sums;  // at that depth; the entering element counts with its share
  // of the load that the entering element would carry; 1: no element is partly loaded
  double marginalShare = 1;
};

/// Solves the balance with passes in one lane. load = F_N / 4G (m^2, > 0); relaxationLength: c = v
/// tau (m).
NodalBalance balanceNodal(const PreparedProfile& line, double relaxationLength, double load);

/// Solves it for at most laneCount() relaxation lengths side by side, which share every pass.
/// guesses: depths nearby (m), or 0. Returns false where `stop` was requested. No allocation.
bool balanceNodalLanes(const PreparedProfile& line, std::span<const double> relaxationLengths,
                       double load, const LaneValues& guesses, const std::stop_token& stop,
                       std::span<NodalBalance> balances);

/// One balance, whose caller runs the passes, so that many balances share them. Plain value; no
/// allocation.
class NodalSearch {
 public:
  /// load = F_N / 4G (m^2); guess: a depth near the answer (m), or 0.
  void start(const PreparedProfile& line, double load, double guess);

  bool isDone() const { return stage_ == Stage::Done; }
  /// Returns the depth (m) of the next pass; the other function returns its output.
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

}  // namespace asperity
