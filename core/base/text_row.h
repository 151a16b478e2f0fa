// The fast way to read rows of a text table. Pure; any thread.
#pragma once

#include <span>
#include <string_view>

#include "core/base/text_dialect.h"

namespace asperity {

/// Reads a row of exactly `numbers.size()` plain numbers; false where there is anything else, which
/// the slow way looks at.
bool readPlainRow(std::string_view line, const TextDialect& dialect, std::span<double> numbers);

}  // namespace asperity
