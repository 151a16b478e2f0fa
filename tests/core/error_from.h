// What the program says of input that it refuses.
#pragma once

#include <string>
#include <vector>

#include "core/base/input_error.h"
#include "core/scene/scene_file.h"

namespace asperity {

/// Returns the text of the InputError that the work throws; "no error" where it throws none.
template <class Work>
std::string errorFrom(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// Returns what is said of a scene file that is refused.
inline std::string errorOfScene(const std::string& json,
                                const std::vector<std::string>& assignments = {}) {
  return errorFrom([&] { readScene(json, "s.json", {}, assignments); });
}

}  // namespace asperity
