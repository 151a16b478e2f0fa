// Numbers as a user types and reads them in the panels: parsing what was typed, units and
// prefixes, what is allowed. Pure; window's thread (the language may change).
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

/// A number with a comma instead of a point, "2,5 mm", with a point; any other text as it is.
QString withPoint(const QString& text);

/// The number in plain `unit` ("Pa", "m/s"), as text: "1e7" for "10 MPa" in "Pa". Prefixes from f
/// to P. A text with no unit, or another one, comes back as it is: the parameter's own reader has
/// the word.
QString inPlainUnit(const QString& text, const QString& unit);

/// A number and its unit as people say them: "10" and "MPa".
struct UnitText {
  QString number, unit;

  bool operator==(const UnitText&) const = default;
};

/// A value in plain `unit`, with the prefix from p to G that leaves one to three digits before the
/// point; lengths, times and velocities have none above 1, kelvins and pure numbers none at all.
/// Reads back to the very number.
UnitText inReadableUnit(double value, const QString& unit);

/// A typed number alone is in the unit that is shown, and gets it; one with an exponent ("1e7") is
/// in the plain unit, as scene files have it, and stays as it is, like any text with a unit.
QString inShownUnit(const QString& text, const QString& shownUnit);

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
