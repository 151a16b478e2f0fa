// What has to be set over one scene so that it becomes another, as assignments (KEY=VALUE) and as
// one text. Pure functions; any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

/// Returns "KEY=VALUE" of every key that differs, in the table's order: readScene(text of base,
/// ..., assignments) is `scene` up to the folder and to keys that have no meaning in it.
std::vector<std::string> differingAssignments(const Scene& base, const Scene& scene);

/// Join assignments to "KEY=VALUE;KEY=VALUE", and separate them. A ';' inside a value is written
/// "\;", and a '\' "\\".
std::string joinedAssignments(const std::vector<std::string>& assignments);
std::vector<std::string> separatedAssignments(std::string_view text);

}  // namespace asperity
