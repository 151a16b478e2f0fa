// Numbers as a user types and reads them in the panels: parsing of input, units and prefixes,
// allowed ranges. Pure; window's thread (the language may change).
#pragma once

#include <QString>
#include <string_view>

#include "core/scene/parameters.h"
#include "ui/language/language.h"

namespace asperity {

/// Returns the shortest text that reads back to the same number: "0.0034", "1e7", "5e-7".
QString numberText(double value);

/// Returns the same with the decimal sign of the current language.
QString shownNumber(double value);

/// Returns printedQuantity() in the current language, as widgets show readings.
QString quantityLabel(double value, std::string_view unit, int digits = 3);

/// Returns the value as an entry field shows it.
QString valueText(const ParameterValue& value);

/// Returns rich text without its tags.
QString withoutTags(QString html);
/// Returns HTML as a screen reader reads it.
QString spokenText(const QString& html);

/// Returns "F_N" and "tau" as rich text in italics: F with a lowered N, the Greek letter.
QString symbolHtml(std::string_view symbol);

/// Returns the text in the quotation marks of the current language.
QString inQuotes(const QString& text);

/// Returns a word of a choice in the current language: "self_affine" as "self-affine", and "line"
/// of the key "surface.form" as "straight line".
QString wordText(std::string_view word, std::string_view key = {});

/// Replaces the comma in a number such as "2,5 mm" by a point; any other text is unchanged.
QString withPoint(const QString& text);

/// Returns a number as people type it without the marks between its thousands, as the current
/// language writes them, and with a decimal point: "2.560" in German and "2,560" in English are
/// "2560". A unit may follow; any other text is unchanged.
QString withoutGroups(const QString& text);

/// A number and its unit in usual notation: "10" and "MPa".
struct UnitText {
  QString number, unit;

  bool operator==(const UnitText&) const = default;
};

/// Returns a value in plain `unit` with the prefix from p to G that leaves one to three digits
/// before the point; lengths, times and velocities have no prefix above 1, kelvins and pure numbers
/// none at all. It reads back to the same number.
UnitText inReadableUnit(double value, const QString& unit);

/// Returns a typed number ("20", "2e1") with the unit that is shown, if it has none; any other text
/// is unchanged.
QString inShownUnit(const QString& text, const QString& shownUnit);

/// The rule for the values of an entry.
struct NumberRule {
  QString unit;  // plain: "Pa"; empty for a pure number
  double minimum = 0, maximum = 0;
  bool isWhole = false;
  bool isTemperature = false;  // on the absolute scale: degrees Celsius are accepted, too
};

/// Returns the rule of a row with a RealField or an IntegerField.
NumberRule numberRule(const Parameter& parameter);

/// Returns "0 to 1", "1 nm to 1000 m" or "1 to 2000 K".
QString allowedInWords(const NumberRule& rule);

/// Returns the number in the plain unit as text, "1e7" for "10 MPa", "313.15" for "40 °C"; also for
/// bar, min, h, km/h, poise and per cent. Prefixes from f to P. Any other text is unchanged; the
/// parameter's own reader handles it.
QString toPlainNumber(const QString& text, const NumberRule& rule);

/// Returns why the text is refused: another dimension, an unknown unit, no number, outside the
/// range. Empty where none of these applies.
QString validationError(const QString& text, const NumberRule& rule);

}  // namespace asperity
