// What people type where a number is wanted, and why it is refused, in their own words and units.
// Pure once the language is chosen; any thread.
#pragma once

#include <QString>

#include "core/scene/parameters.h"

namespace asperity {

/// What an entry takes.
struct NumberRule {
  QString unit;  // plain: "Pa"; empty for a pure number
  double minimum = 0, maximum = 0;
  bool isWhole = false;
  bool isTemperature = false;  // on the absolute scale: degrees Celsius can be told from kelvins
};

/// Of a row with a RealField or an IntegerField.
NumberRule ruleOf(const Parameter& parameter);

/// "0 to 1", "1 nm to 1000 m", "1 to 2000 K".
QString allowedInWords(const NumberRule& rule);

/// The number in the plain unit as text, "1e7" of "10 MPa", "313.15" of "40 °C"; also of bar, min,
/// h, km/h, poise and per cent. Any other text as it is.
QString plainNumberOf(const QString& text, const NumberRule& rule);

/// Why the text is refused: another dimension, an unknown unit, no number, outside the range.
/// Empty where nothing of this is wrong with it.
QString refusalOf(const QString& text, const NumberRule& rule);

}  // namespace asperity
