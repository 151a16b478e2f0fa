// The rows of a table of measured friction as points in SI units, by the roles of its columns, and
// doubts about these points: velocities that repeat, friction in per cent, a force of friction in
// place of the load, a slip of a decimal mark.
// Pure functions; any thread. Failure: InputError that names the file and the row or column.
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

/// Throws InputError for fewer than two points.
void requirePoints(const std::vector<MeasuredPoint>& points, const std::string& name);

/// Throws InputError for points of one table that cannot be what its columns say.
void checkColumns(const std::vector<MeasuredPoint>& points, const TextBlock& block,
                  const FrictionRoles& roles, const std::string& name);

/// Throws InputError for points that no test of rubber gives, and for two that nothing tells apart.
/// haveVelocities: each row of the file has its own velocity.
void checkPoints(const std::vector<MeasuredPoint>& points, bool haveVelocities,
                 const std::string& name);

/// Returns a note on each point that is many times higher or lower than its neighbours: one slip of
/// a decimal mark moves a whole fit.
std::vector<Message> slipNotes(const std::vector<MeasuredPoint>& points);

}  // namespace asperity
