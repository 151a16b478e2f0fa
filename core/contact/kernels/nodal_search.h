// The indentation at which the paper's elements carry a load, asked for step by step, so that many
// searches share their passes: next() says at which depth to look, take() what was found there.
// F_N(d) is a rising staircase of straight pieces: loaded elements only join as d grows, so two
// depths with as many loaded elements have the same ones, and between them F_N is straight. Where
// they differ by one, its threshold settles the rest. Plain value; no allocation.
#pragma once

#include "core/contact/force_balance.h"
#include "core/contact/kernels/pass_sums.h"

namespace asperity {

/// What a pass found, per 4G.
struct NodalLook {
  double depth = 0;      // m, where
  double force = 0;      // m^2
  double loaded = 0;     // elements
  double threshold = 0;  // m
  StateSums sums;        // threshold and sums only where everything was asked for
};

class NodalSearch {
 public:
  /// load = F_N / 4G (m^2), spacing dx (m); upper: a depth (m) that surely carries it, or a guess.
  void start(double load, double spacing, double upper, double guess);

  bool isDone() const { return stage_ == Stage::Done; }
  double nextDepth() const { return next_; }
  bool wantsEverything() const { return stage_ >= Stage::Threshold; }
  void take(const NodalLook& look);

  const NodalBalance& answer() const { return answer_; }

 private:
  enum class Stage { Bracket, Narrow, Threshold, Above, Below, Answer, Done };

  void takeBracket(const NodalLook& look);
  void takeNarrow(const NodalLook& look);
  void takeThreshold(const NodalLook& look);
  void takeAbove(const NodalLook& look);
  void takeBelow(const NodalLook& look);
  void takeAnswer(const NodalLook& look);
  void chooseNext();
  double pointInside() const;
  void halve();
  void askAround(double edge);
  void ask(Stage stage, double depth);
  void finishBetween(const NodalLook& less, const NodalLook& more);
  bool isEnough(const NodalLook& look) const { return look.force >= load_; }
  double stiffness(const NodalLook& look) const { return look.loaded * spacing_; }

  double load_ = 0, spacing_ = 0, upperBound_ = 0, next_ = 0;
  NodalLook lower_, upper_;  // too little force, enough
  NodalLook above_;          // at the threshold of the element that enters last
  double edge_ = 0;          // m, its indentation
  double reach_ = 0;         // how far from it the looks go, relative
  int passes_ = 0, sameSide_ = 0;
  bool lastWasEnough_ = false, halving_ = false;
  Stage stage_ = Stage::Done;
  NodalBalance answer_;
};

}  // namespace asperity
