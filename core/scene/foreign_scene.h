// A scene that comes inside of a picture, film or table may be another person's: what it asks for
// beyond being shown, so that its reader can be asked first. Pure but for a look at file names; any
// thread.
#pragma once

#include <filesystem>

#include "core/scene/scene.h"

namespace asperity {

/// What such a scene may take unasked.
inline constexpr double kMemoryUnasked = 1e9;   // bytes
inline constexpr double kSecondsUnasked = 600;  // of one processor

struct SceneDemands {
  std::filesystem::path file;  // a profile that lies neither beside the scene nor below; or empty
  double memory = 0;           // bytes, where it is more than kMemoryUnasked, roughly
  double seconds = 0;          // of one processor, where it is more than kSecondsUnasked, roughly

  bool any() const { return !file.empty() || memory > 0 || seconds > 0; }
};

/// scene.folder: where the file lies that carries the scene.
SceneDemands demandsOf(const Scene& scene);

}  // namespace asperity
