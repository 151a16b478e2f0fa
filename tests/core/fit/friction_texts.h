// Tables of measured friction as texts.
#pragma once

#include <string>

#include "core/base/text_number.h"
#include "core/fit/friction_data.h"
#include "tests/core/error_from.h"

namespace asperity {

inline FrictionData parsed(const std::string& text) {
  return parseFrictionData(text, "mine.csv");
}

/// Reads a text whose commas are replaced by a separator.
inline FrictionData parsed(std::string text, const char* separator) {
  replaceAll(text, ",", separator);
  return parsed(text);
}

inline std::string errorOf(const std::string& text) {
  return errorFrom([&] { parsed(text); });
}

}  // namespace asperity
