// What the paper says, held against what was computed: one entry for each quantitative sentence.
// Plain values; pure functions; any thread.
#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/friction/study.h"

namespace asperity {

/// Undecided: the number lies within two standard errors of a border of the criterion, so that
/// other random lines may say the opposite; or there is no number, or no standard error of it.
enum class Verdict { Yes, No, Undecided, OnlyForScheme };

/// The values for which a claim holds. Infinite where there is no border.
struct Bounds {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();

  /// Distance to the nearest border, below 0 outside.
  double margin(double value) const;
};
Bounds within(double expected, double allowed);
Bounds below(double border);
Bounds above(double border);

struct Claim {
  std::string id{};    // "slope_in_region_1"
  Message where{};     // in the paper: "p. 2, Fig. 2"
  Message claim{};     // what is said there
  Message quantity{};  // what `measured` is, with its unit
  Estimate measured{};
  double expected = kNotApplicable;  // by the paper; not every claim has a number
  Message criterion{};               // when it holds, in words
  Bounds bounds{};                   // the same in numbers
  Verdict holds = Verdict::Undecided;
  Message scheme{};  // with OnlyForScheme: which
  Message note{};
};

/// Of a number that is averaged over random lines.
Verdict verdict(const Estimate& measured, const Bounds& bounds);

/// No where one of them is, else Undecided where one of them is.
Verdict both(Verdict a, Verdict b);

/// Gives the claim its number, its bounds and the verdict that follows from them.
void decide(Claim& claim, const Estimate& measured, const Bounds& bounds);

/// The same of a number that has no uncertainty but rounding. NaN: there is nothing to measure.
void decideExactly(Claim& claim, double value, const Bounds& bounds);

/// The same of several numbers, all of which have to lie within the bounds. The claim is given the
/// one that decides, whose place is returned: a No before an Undecided before a Yes, and of equal
/// verdicts the one with the smallest margin.
std::size_t decideByAll(Claim& claim, std::span<const Estimate> measured, const Bounds& bounds);

/// "yes", "no", "undecided", "only for scheme ...".
std::string holdsText(const Claim& claim);

/// {id, where, claim, quantity, measured, uncertainty, expected, criterion, holds_from, holds_to,
/// holds, note}; what does not apply is null.
nlohmann::ordered_json claimJson(const Claim& claim);

}  // namespace asperity
