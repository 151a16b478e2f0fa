// What a scene inside a picture, film or table needs beyond being shown. Such a scene may come from
// another user, so the user is asked first if it reads a file from another folder, or takes much
// memory or time. Reads the sizes and places of files; any thread.
#pragma once

#include <filesystem>

#include "core/scene/scene.h"

namespace asperity {

/// Limits of memory and time below which a user is not asked.
inline constexpr double kMemoryUnasked = 1e9;   // bytes
inline constexpr double kSecondsUnasked = 600;  // of one processor

struct SceneDemands {
  std::filesystem::path file;  // one outside of the scene's folder and its subfolders, or empty
  double memory = 0;           // bytes, if more than kMemoryUnasked; approximate
  double seconds = 0;          // of one processor, if more than kSecondsUnasked; approximate

  bool any() const { return !file.empty() || memory > 0 || seconds > 0; }
};

/// Returns the demands. scene.folder: the folder of the file that contains the scene.
SceneDemands sceneDemands(const Scene& scene);

}  // namespace asperity
