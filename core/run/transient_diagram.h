// What happened during a motion as strips over time, one above the other. Pure; any thread.
#pragma once

#include <span>

#include "core/friction/diagram.h"
#include "core/run/transient_sample.h"
#include "core/scene/scene.h"

namespace asperity {

/// Velocity, friction and indentation over the scene's whole duration, as far as samples go.
DiagramSheet transientSheet(const Scene& scene, std::span<const TransientSample> samples);

}  // namespace asperity
