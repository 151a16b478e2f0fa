#include "core/paper/claim.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/base/number_text.h"

namespace asperity {
namespace {

constexpr double kStandardErrors = 2;  // distance from a border that a verdict needs

/// Returns the rank of a verdict; the lowest one decides if there are several.
int rank(Verdict verdict) {
  switch (verdict) {
    case Verdict::No:
      return 0;
    case Verdict::Undecided:
      return 1;
    default:
      return 2;
  }
}

}  // namespace

double Bounds::margin(double value) const {
  return std::min(value - from, to - value);
}

Bounds within(double expected, double allowed) {
  return {expected - allowed, expected + allowed, message("within {} of {}", allowed, expected)};
}

Bounds between(double from, double to) {
  return {from, to, message("between {} and {}", from, to)};
}

Bounds below(double border) {
  return {Bounds{}.from, border, message("below {}", plain(border))};
}

Bounds above(double border) {
  return {border, Bounds{}.to, message("above {}", border)};
}

Verdict verdict(const Estimate& measured, const Bounds& bounds) {
  if (!std::isfinite(measured.value) || !std::isfinite(measured.standardError))
    return Verdict::Undecided;
  const double margin = bounds.margin(measured.value);
  const double needed = kStandardErrors * measured.standardError;
  if (needed > 0 && std::abs(margin) <= needed) return Verdict::Undecided;
  return margin >= 0 ? Verdict::Yes : Verdict::No;
}

Verdict both(Verdict a, Verdict b) {
  return rank(a) <= rank(b) ? a : b;
}

namespace {

void setResult(Claim& claim, const Estimate& measured, const Bounds& bounds, Verdict holds) {
  claim.measured = measured;
  claim.bounds = bounds;
  claim.holds = holds;
  if (claim.criterion.empty()) claim.criterion = bounds.words;
}

}  // namespace

void decide(Claim& claim, const Estimate& measured, const Bounds& bounds) {
  setResult(claim, measured, bounds, verdict(measured, bounds));
}

void decideExactly(Claim& claim, double value, const Bounds& bounds) {
  setResult(claim, {value, kNotApplicable}, bounds, verdict({value, 0}, bounds));
}

void decideZero(Claim& claim, double value) {
  constexpr double kRounding = 1e-9;
  claim.expected = 0;
  decideExactly(claim, value, below(kRounding));
}

std::size_t decideByAll(Claim& claim, std::span<const Estimate> measured, const Bounds& bounds) {
  std::size_t deciding = 0;
  for (std::size_t i = 1; i < measured.size(); ++i) {
    const int one = rank(verdict(measured[i], bounds));
    const int other = rank(verdict(measured[deciding], bounds));
    const bool isNearer =
        bounds.margin(measured[i].value) < bounds.margin(measured[deciding].value);
    if (one < other || (one == other && isNearer)) deciding = i;
  }
  decide(claim, measured.empty() ? Estimate{} : measured[deciding], bounds);
  return deciding;
}

namespace {

/// Returns "yes", "no", "undecided" or "only for scheme ...".
std::string holdsText(const Claim& claim) {
  switch (claim.holds) {
    case Verdict::Yes:
      return "yes";
    case Verdict::No:
      return "no";
    case Verdict::Undecided:
      return "undecided";
    case Verdict::OnlyForScheme:
      break;
  }
  return "only for scheme " + claim.scheme.english();
}

}  // namespace

nlohmann::ordered_json claimJson(const Claim& claim) {
  nlohmann::ordered_json json;
  json["id"] = claim.id;
  json["where"] = claim.where.english();
  json["claim"] = claim.claim.english();
  json["quantity"] = claim.quantity.english();
  json["measured"] = numberOrNull(claim.measured.value);
  json["uncertainty"] = numberOrNull(claim.measured.standardError);
  json["expected"] = numberOrNull(claim.expected);
  json["criterion"] = claim.criterion.english();
  json["holds_from"] = numberOrNull(claim.bounds.from);
  json["holds_to"] = numberOrNull(claim.bounds.to);
  json["holds"] = holdsText(claim);
  json["note"] = claim.note.english();
  return json;
}

}  // namespace asperity
