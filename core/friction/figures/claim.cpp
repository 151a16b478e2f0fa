#include "core/friction/figures/claim.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace asperity {
namespace {

nlohmann::ordered_json numberOrNull(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}  // namespace

Verdict verdict(bool holds) {
  return holds ? Verdict::Yes : Verdict::No;
}

std::string holdsText(const Claim& claim) {
  switch (claim.holds) {
    case Verdict::Yes:
      return "yes";
    case Verdict::No:
      return "no";
    case Verdict::OnlyForScheme:
      break;
  }
  return "only for scheme " + claim.scheme;
}

nlohmann::ordered_json claimJson(const Claim& claim) {
  nlohmann::ordered_json json;
  json["id"] = claim.id;
  json["where"] = claim.where;
  json["claim"] = claim.claim;
  json["quantity"] = claim.quantity;
  json["measured"] = numberOrNull(claim.measured.value);
  json["uncertainty"] = numberOrNull(claim.measured.standardError);
  json["expected"] = numberOrNull(claim.expected);
  json["criterion"] = claim.criterion;
  json["holds"] = holdsText(claim);
  json["note"] = claim.note;
  return json;
}

}  // namespace asperity
