// Numbers and ranges as people type them: what is allowed, in messages, help and tables. Pure; any
// thread.
#pragma once

#include <string>
#include <string_view>

#include "core/base/message.h"

namespace asperity {

/// Reads back to the same number: "0.05", "-10000000", "1e-6"; the exponent without padding.
std::string plainNumber(double value);

/// The same as a value of a message.
PrintedNumber plain(double value);

/// "0 to 1", "1e-6 to 1e15 Pa": six digits, which every limit of the table has.
Message rangeText(double minimum, double maximum, std::string_view unit = {});

}  // namespace asperity
