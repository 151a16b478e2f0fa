// Which columns of a table of measured friction give what: the velocity, the coefficient of
// friction or what it is computed from, their errors, the load and the temperature; and how their
// numbers become SI units and standard errors, by the unit and the name of the column. A column
// that may be one of these, and is not understood, is refused. Pure functions; any thread. Failure:
// InputError that names the file and the column.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// A column that is used.
struct FrictionRole {
  FrictionQuantity quantity = FrictionQuantity::Label;
  std::size_t index = 0;  // of the column
  FrictionConversion conversion{};
  Message note{};  // "column 2: velocity (mm/s)"
};

struct FrictionRoles {
  std::vector<FrictionRole> columns{};
  std::vector<std::size_t> repeats{};  // columns of one coefficient of friction, "mu1", "mu2"
  std::optional<FrictionRole> forceOfFriction{};  // beside a coefficient of friction

  /// Returns the first column of a quantity; null where there is none.
  const FrictionRole* find(FrictionQuantity quantity) const;
  /// Returns whether a column gives this load, the temperature or the velocity; a force and a
  /// pressure both say the load.
  bool isGiven(FrictionQuantity quantity) const;
  /// Returns whether a column is used.
  bool isUsed(std::size_t index) const;
  /// Returns whether the errors in the cells of a column are used.
  bool areErrorsUsed(const TextBlock& block, std::size_t index) const;
};

/// Finds the roles of the columns. The columns need names unless there are two or three. name: of
/// the file.
FrictionRoles findRoles(const TextBlock& block, const std::string& name);

/// Throws InputError for a column without a unit where a line above or below the table names one of
/// its quantity that is not that of SI, such as "v in mm/s".
void refuseUnitsElsewhere(const TextPart& in, const FrictionRoles& roles, const std::string& name);

/// Throws InputError where neither a column nor a line above the table gives the velocity, or the
/// normal force beside a force of friction. isStated: whether such a line gives a quantity.
void requireQuantities(const TextBlock& block, const FrictionRoles& roles,
                       const std::function<bool(FrictionQuantity)>& isStated,
                       const std::string& name);

}  // namespace asperity
