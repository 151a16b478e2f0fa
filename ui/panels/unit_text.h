// What a person types with a unit: "10 MPa", "3.4 mN", "20 mm", "0.5 ms". Pure; any thread.
#pragma once

#include <QString>

namespace asperity {

/// The number in plain `unit` ("Pa", "m/s"), as text: "1e7" for "10 MPa" in "Pa". Prefixes from p
/// to G. A text with no unit, or another one, comes back as it is: the parameter's own reader has
/// the word.
QString inPlainUnit(const QString& text, const QString& unit);

}  // namespace asperity
