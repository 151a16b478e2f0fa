// Random scenes over the whole table of parameters, as settings that rapidcheck can take away one
// by one until a failure has only what it needs.
#pragma once

#include <rapidcheck.h>

#include <string>
#include <vector>

#include "core/scene/parameters.h"

namespace asperity {

/// One row of the table set to a value.
struct Setting {
  std::size_t row = 0;
  ParameterValue value;
};

/// Default scene with these settings; those without a meaning in it are left out. Folder: where the
/// profiles of the tests are.
Scene sceneWith(const std::vector<Setting>& settings);

rc::Gen<std::vector<Setting>> anySettings();
/// The same with a Prony series, whose arms lie anywhere in what the table allows.
rc::Gen<std::vector<Setting>> anySettingsWithArms();

std::ostream& operator<<(std::ostream& stream, const Setting& setting);

}  // namespace asperity
