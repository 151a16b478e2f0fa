// Whether the values of a scene go together, of which each is allowed for itself. Pure; any thread.
#pragma once

#include "core/scene/scene.h"

namespace asperity {

/// Throws InputError with the key that is missing or does not go with another one. Reading a scene
/// checks it; code that sets values of its own calls this afterwards.
void checkScene(const Scene& scene);

}  // namespace asperity
