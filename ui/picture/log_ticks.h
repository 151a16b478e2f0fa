// Decades of a logarithmic axis. Pure; any thread.
#pragma once

#include <string>
#include <vector>

namespace asperity {

/// "10⁻³"; UTF-8.
std::string powerOfTen(int exponent);

/// Exponents of the decades inside [from, to] (> 0), thinned to at most `most` of them.
std::vector<int> decades(double from, double to, int most);

}  // namespace asperity
