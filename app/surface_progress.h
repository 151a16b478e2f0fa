// Progress while a large measured surface is read and analysed, and what its reading rests on. Main
// thread.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

/// Reads the scene's measured surface, if it has one, and finds its lines with a progress bar. Both
/// are then cached for the code that makes lines of the scene (core/surface/measured_lines.h). That
/// code also reports errors, because it knows their context.
void findLinesWithProgress(const Scene& scene, bool quiet);

/// Returns the assumptions about the scene's measured surface, if it has one, that its file does
/// not state: "they are taken as metres". Sentences in the present language.
std::vector<std::string> surfaceAssumptions(const Scene& scene);

}  // namespace asperity
