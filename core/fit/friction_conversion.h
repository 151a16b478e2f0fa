// How the numbers of a column of a table of measured friction become SI units and standard errors,
// by the unit and the name of the column.
// Pure functions; any thread. Failure: InputError that names the file and the column.
#pragma once

#include <string>
#include <string_view>

#include "core/base/message.h"
#include "core/base/text_table.h"
#include "core/base/units.h"
#include "core/fit/friction_columns.h"

namespace asperity {

/// The conversion of the numbers of a column to SI units.
struct FrictionConversion {
  Unit unit{};
  bool isShare = false;  // of the quantity that it is the error of
  double divisor = 1;    // of an error, for one standard error
  bool isVariance = false;
  bool isForce = false;  // of friction, to be divided by the normal force
  Message unitText{};    // for the notes; empty: as the column writes it
};

/// Returns whether a unit is that of a pure number, or missing.
bool isPureUnit(std::string_view unit);

/// Returns the conversion of a column of a table; one without a unit is in SI units. name: of the
/// file. Throws InputError for a unit of another quantity.
FrictionConversion findConversion(FrictionQuantity quantity, const TextColumn& column,
                                  const TextBlock& block, const std::string& name);

}  // namespace asperity
