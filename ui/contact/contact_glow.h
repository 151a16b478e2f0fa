// The light that what is coloured throws down into the elastomer. Private to ui/contact; pure.
#pragma once

#include <vector>

#include "ui/contact/contact_layout.h"
#include "ui/contact/decimate.h"

namespace asperity {

/// Triangles that start at the surface and fade with depth, coloured as the contacts above them.
void addGlow(DrawLayer& layer, const std::vector<CurveVertex>& surface,
             const std::vector<std::vector<CurveVertex>>& contacts, const ContactLayout& layout);

/// How far down it reaches, in pixels; the lower half is hardly seen.
float glowDepth(const ContactLayout& layout);

}  // namespace asperity
