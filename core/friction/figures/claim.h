// What the paper says, held against what was computed: one entry for each quantitative sentence.
// Plain values; pure functions; any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/friction/study.h"

namespace asperity {

enum class Verdict { Yes, No, OnlyForScheme };

struct Claim {
  std::string id{};        // "slope_in_region_1"
  std::string where{};     // in the paper: "p. 2, Fig. 2"
  std::string claim{};     // what is said there
  std::string quantity{};  // what `measured` is, with its unit
  Estimate measured{};
  double expected = kNotApplicable;  // by the paper; not every claim has a number
  std::string criterion{};           // when it holds
  Verdict holds = Verdict::No;
  std::string scheme{};  // with OnlyForScheme: which
  std::string note{};
};

/// Whether it holds as the criterion says.
Verdict verdict(bool holds);

/// "yes", "no", "only for scheme ...".
std::string holdsText(const Claim& claim);

/// {id, where, claim, quantity, measured, uncertainty, expected, criterion, holds, note}; what does
/// not apply is null.
nlohmann::ordered_json claimJson(const Claim& claim);

}  // namespace asperity
