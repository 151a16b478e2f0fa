// A claim of a figure by its name.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "core/paper/figure.h"

namespace asperity {

inline const Claim& claimOf(const Figure& figure, std::string_view id) {
  const auto found = std::ranges::find(figure.claims, id, &Claim::id);
  if (found == figure.claims.end()) throw std::runtime_error("no such claim");
  return *found;
}

}  // namespace asperity
