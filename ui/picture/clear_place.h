// Where a label at the bottom of the axes hides no contact, and where one lies on the body that it
// names. Private to ui/picture; pure.
#pragma once

#include <optional>

#include "ui/picture/contact_layout.h"

namespace asperity {

/// Whether no contact of the whole period, nor the brighter half of its glow, comes below the pixel
/// row `top`: then none ever will while the line slides by.
bool clearAcross(const Frame& frame, const ContactLayout& layout, float top);

/// The left end of a label `width` pixels wide below the row `top` that hides no contact now: at
/// the left, at the right (`margin` from the axes) or in the middle; none where all of them would.
std::optional<float> clearPlace(const Frame& frame, const ContactLayout& layout, float top,
                                float width, float margin);

enum class Body { Rigid, Elastomer };

/// Whether a label in the box lies on the body and not on the other one: while the line slides by,
/// or at least now.
bool liesOn(Body body, const Frame& frame, const ContactLayout& layout, const Box& box);

}  // namespace asperity
