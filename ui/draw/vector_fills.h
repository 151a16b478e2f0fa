// Coloured triangles as fills with one paint each; the part of vector_shapes.h that deals with
// colours. Private to ui/draw. Pure; any thread.
#pragma once

#include <vector>

#include "ui/draw/vector_shapes.h"

namespace asperity {

std::vector<VectorFill> fillsOf(const std::vector<DrawVertex>& triangles);

bool isDrawable(const DrawVertex& vertex);  // finite
/// The same in eight bits a channel.
bool sameColour(const Rgba& a, const Rgba& b);

}  // namespace asperity
