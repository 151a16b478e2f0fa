// Numbers as people write them, and symbols as they are printed. Pure once the language is chosen;
// any thread.
#pragma once

#include <QString>
#include <string_view>

#include "core/scene/parameters.h"

namespace asperity {

/// Nearest number with so many significant decimal digits.
double roundedToDigits(double value, int digits);

/// Shortest text that reads back to the same number: "0.0034", "1e7", "5e-7".
QString numberText(double value);

/// The same with the decimal sign of the language in use.
QString shownNumber(double value);

/// The value as it stands in an entry field.
QString valueText(const ParameterValue& value);

/// "F_N" and "tau" as rich text in italics: F with a lowered N, the Greek letter.
QString symbolHtml(std::string_view symbol);

/// "self_affine" as "self-affine", in the language in use.
QString wordText(std::string_view word);

inline QString fromUtf8(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace asperity
