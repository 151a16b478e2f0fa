// The table of what is hard for the numbers: each row a situation that a slider can reach.
#pragma once

#include <string>
#include <vector>

#include "tests/stability/invariants.h"

namespace asperity {

struct HardCase {
  std::string name;
  std::string why;  // what is hard about it
  Situation situation;
};

/// Every row, each under the schemes it is meant for.
std::vector<HardCase> hardCases();

}  // namespace asperity
