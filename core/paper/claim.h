// The paper's statements compared with computed results: one entry for each quantitative sentence.
// Plain values; pure functions; any thread.
#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "core/base/message.h"
#include "core/friction/jackknife.h"

namespace asperity {

/// Undecided: the number lies within two standard errors of a border of the criterion, so that
/// other random lines may give the opposite verdict; or there is no number, or no standard error of
/// it.
enum class Verdict { Yes, No, Undecided, OnlyForScheme };

/// The values for which a claim holds. Infinite where there is no border.
struct Bounds {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  Message words{};  // "below 0.1"

  /// Returns the distance to the nearest border, below 0 outside.
  double margin(double value) const;
};
Bounds within(double expected, double allowed);
Bounds between(double from, double to);
Bounds below(double border);
Bounds above(double border);

struct Claim {
  std::string id{};    // "slope_in_region_1"
  Message where{};     // place in the paper: "p. 2, Fig. 2"
  Message claim{};     // the statement there
  Message quantity{};  // meaning of `measured`, with its unit
  Estimate measured{};
  double expected = kNotApplicable;  // value in the paper; not every claim has one
  Message criterion{};               // condition for the claim; set before decide(), or its bounds
  Bounds bounds{};                   // the same as numbers
  Verdict holds = Verdict::Undecided;
  Message scheme{};  // for OnlyForScheme: the scheme
  Message note{};
};

/// Returns the verdict on a number that is averaged over random lines.
Verdict verdict(const Estimate& measured, const Bounds& bounds);

/// Returns No if one of them is No, else Undecided if one of them is.
Verdict both(Verdict a, Verdict b);

/// Sets the claim's number, its bounds and the resulting verdict, and the criterion where the claim
/// has none in other words.
void decide(Claim& claim, const Estimate& measured, const Bounds& bounds);

/// Does the same for a number without uncertainty except for rounding. NaN: there is no number.
void decideExactly(Claim& claim, double value, const Bounds& bounds);

/// Does the same for a number that should be 0 but for rounding.
void decideZero(Claim& claim, double value);

/// Does the same for several numbers, all of which must lie within the bounds. The claim gets the
/// decisive one, whose index is returned: a No before an Undecided before a Yes, and among equal
/// verdicts the one with the smallest margin.
std::size_t decideByAll(Claim& claim, std::span<const Estimate> measured, const Bounds& bounds);

/// Returns {id, where, claim, quantity, measured, uncertainty, expected, criterion, holds_from,
/// holds_to, holds, note}; a value that does not apply is null.
nlohmann::ordered_json claimJson(const Claim& claim);

}  // namespace asperity
