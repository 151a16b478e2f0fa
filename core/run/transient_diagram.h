// What happened during a motion as strips over time, one above the other. Pure; any thread.
#pragma once

#include <span>

#include "core/chart/diagram.h"
#include "core/run/transient_sample.h"
#include "core/scene/scene.h"

namespace asperity {

/// Velocity, friction and indentation over the scene's whole duration, as far as samples go, with
/// the estimated error of friction as a band. spacing, period: of the line, m, so that its ripple
/// is not magnified (strip_range.h); 0: unknown.
DiagramSheet transientSheet(const Scene& scene, std::span<const TransientSample> samples,
                            double spacing = 0, double period = 0);

/// Contact fraction as one more strip.
Diagram contactStrip(const Scene& scene, std::span<const TransientSample> samples);

}  // namespace asperity
