// Which columns of a table of measured friction give what: the velocity, the coefficient of
// friction or what it is computed from, their errors, the load and the temperature. A column that
// may be one of these, and is not understood, is refused. Pure functions; any thread. Failure:
// InputError that names the file and the column.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/text_table.h"
#include "core/fit/friction_columns.h"
#include "core/fit/friction_conversion.h"

namespace asperity {

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
void refuseUnitsElsewhere(const TextTable& table, const TextBlock& block,
                          const FrictionRoles& roles, const std::string& name);

/// Throws InputError where neither a column nor a line above the table gives the velocity, or the
/// normal force beside a force of friction. isStated: whether such a line gives a quantity.
void requireQuantities(const TextBlock& block, const FrictionRoles& roles,
                       const std::function<bool(FrictionQuantity)>& isStated,
                       const std::string& name);

}  // namespace asperity
