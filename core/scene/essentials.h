// The few parameters of a scene that a person changes first, and the parameter that a note is
// about. Pure; any thread.
#pragma once

#include <string_view>
#include <vector>

#include "core/scene/notes.h"
#include "core/scene/scene.h"

namespace asperity {

inline constexpr std::size_t kMaxEssentials = 8;

/// Returns the keys that matter first: velocity, load, stiffness, roughness. Each one has a meaning
/// in the scene; at most kMaxEssentials, in the order in which they are shown.
std::vector<std::string_view> essentialKeys(const Scene& scene);

/// Returns the key of the number or the file that a note is about, which has a meaning in the
/// scene: the one whose change makes the note go away.
std::string_view noteKey(Note note, const Scene& scene);

}  // namespace asperity
