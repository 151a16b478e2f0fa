// What the lines above a table of measured friction state of all its points ("Load = 30 N,
// T = 23 °C", "v = 10 mm/s"), in English and German.
// Pure functions; any thread. Failure: InputError that names the file and the line.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
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

/// A load, a temperature or the velocity in a line above the table.
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
  bool isNegative = false;  // a load below 0, by a convention of signs; value is its magnitude
  bool isSentence = false;  // "Tested at 23 °C", which has no name of the quantity
};

/// What the lines above a table state.
struct HeaderStatements {
  std::vector<HeaderStatement> common{};  // of all points
  std::vector<HeaderStatement> unused{};  // not understood, doubtful, or given by a column
  bool hasTwoLoads = false;               // several loads are stated, so that none counts

  /// Returns whether a line gives the quantity of all points.
  bool hasCommon(FrictionQuantity quantity) const {
    return std::ranges::find(common, quantity, &HeaderStatement::quantity) != common.end();
  }
};

/// Reads all lines above a table. isGiven: whether a column gives a quantity. name: of the file.
/// Throws InputError for a load or temperature that is not understood and may be the one meant,
/// unless another line or a column gives it.
HeaderStatements readHeader(const std::vector<TextEntry>& header, HeaderMark mark,
                            const std::function<bool(FrictionQuantity)>& isGiven,
                            const std::string& name);

/// Adds what lines below a table state to what those above it state, which precedes.
void addBelow(HeaderStatements& above, HeaderStatements below);

}  // namespace asperity
