// The rows of a table of measured friction as points in SI units, by the roles of its columns.
// Pure functions; any thread. Failure: InputError that names the file and the row.
#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/text_table.h"
#include "core/fit/friction_data.h"
#include "core/fit/friction_header.h"
#include "core/fit/friction_roles.h"

namespace asperity {

struct FrictionRows {
  std::vector<MeasuredPoint> points{};
  /// Which rows are left out, which signs were turned, and what contradicts friction.
  std::vector<Message> notes{};
};

/// Reads the rows. common: what the lines above the table state of all points. name: of the file.
FrictionRows readRows(const TextBlock& block, const FrictionRoles& roles,
                      const std::vector<HeaderStatement>& common, const std::string& name);

}  // namespace asperity
