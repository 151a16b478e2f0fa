// Numbers with engineering units, typed and shown: "10 MPa", "3.4 mN", "20 mm", "0,5 ms". Pure;
// any thread.
#pragma once

#include <QString>

namespace asperity {

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

}  // namespace asperity
