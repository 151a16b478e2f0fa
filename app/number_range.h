// FROM:TO as written on the command line. Pure.
#pragma once

#include <string>

namespace asperity {

struct NumberRange {
  double from = 0, to = 0;
};

/// Two finite numbers, the first one below the second. Throws InputError naming the option; unit:
/// of both, for its sentence; may be empty.
NumberRange rangeFrom(const std::string& option, const std::string& text, const std::string& unit);

}  // namespace asperity
