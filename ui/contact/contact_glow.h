// The light below coloured parts of the elastomer's surface. Private to ui/contact; pure.
#pragma once

#include <vector>

#include "ui/contact/contact_layout.h"
#include "ui/contact/decimate.h"

namespace asperity {

/// Adds triangles that start at the surface and fade with depth, in the colours of the contacts
/// above.
void addGlow(DrawLayer& layer, const std::vector<CurveVertex>& surface,
             const std::vector<std::vector<CurveVertex>>& contacts, const ContactLayout& layout);

/// Returns the depth of the light in pixels; its lower half is hardly visible.
float glowDepth(const ContactLayout& layout);

}  // namespace asperity
