// What the lines above a table of measured friction state of all its points ("Load = 30 N,
// T = 23 °C"), in English and German. Pure functions; any thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/text_table.h"
#include "core/fit/friction_columns.h"

namespace asperity {

/// The decimal mark of a file.
struct HeaderMark {
  char decimal = '.';
  bool isKnown = true;  // otherwise "4.000" may be four or four thousand
};

/// A load or temperature in a line above the table.
struct HeaderStatement {
  std::string text{};  // of the line, for notes
  std::size_t line = 0;
  std::optional<FrictionQuantity> quantity{};  // nothing where it is not understood
  double value = 0;                            // SI; of a quantity
  std::string groupedNumber{};  // the number as written where its thousands are separated
  double number = 0;            // as written, without the unit
  /// The load or temperature that may be meant where it is not understood; nothing where the line
  /// names another thing, such as the air.
  std::optional<FrictionQuantity> candidate{};
};

/// Returns the loads and temperatures that a line states, also those that are not understood but
/// have a unit of such a quantity.
std::vector<HeaderStatement> readStatements(const TextEntry& entry, HeaderMark mark);

}  // namespace asperity
