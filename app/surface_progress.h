// Progress while a large measured surface is read and analysed. Main thread.
#pragma once

#include "core/scene/scene.h"

namespace asperity {

/// Reads the scene's measured surface, if it has one, and finds its lines with a progress bar. Both
/// are then known to whoever makes lines of the scene (core/surface/measured_lines.h). Errors are
/// left to them, who know the context.
void findLinesWithProgress(const Scene& scene, bool quiet);

}  // namespace asperity
