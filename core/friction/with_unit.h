// Quantities as people write them. Pure; any thread.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// "3.4 mN": three digits and a prefix.
std::string withUnit(double value, std::string_view unit);

}  // namespace asperity
