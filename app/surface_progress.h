// Progress while a large measured surface is read and analysed, and what its reading rests on. Main
// thread.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

/// Reads the scene's measured surface, if it has one, and finds its lines with a progress bar. Both
/// are then known to whoever makes lines of the scene (core/surface/measured_lines.h). Errors are
/// left to them, who know the context.
void findLinesWithProgress(const Scene& scene, bool quiet);

/// What was supposed of the scene's measured surface, if it has one, because its file does not say
/// it: "they are taken as metres". Sentences in the present language.
std::vector<std::string> surfaceAssumptions(const Scene& scene);

}  // namespace asperity
