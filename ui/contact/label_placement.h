// Finds positions at which a label hides no contact, is not crossed by the line of its body, and
// lies on the body that it names. Private to ui/contact; pure.
#pragma once

#include <optional>
#include <vector>

#include "ui/contact/contact_layout.h"

namespace asperity {

/// Returns whether no contact of the whole period, nor the brighter half of its glow, comes below
/// the pixel row `top`: then none ever will while the line slides by.
bool clearAcross(const Frame& frame, const ContactLayout& layout, float top);

/// Returns the left end of a label `width` pixels wide below the row `top` that hides no contact
/// now: where it was last, at the left, at the right (`margin` from the axes) or in the middle;
/// none where all of them would hide one.
std::optional<float> labelPlacement(const Frame& frame, const ContactLayout& layout, float top,
                                    float width, float margin, std::optional<float> last = {});

/// Returns whether the whole period of the rigid line stays below the pixel row `bottom`: then it
/// never crosses a label above the row while it slides by.
bool lineStaysBelow(const Frame& frame, const ContactLayout& layout, float bottom);

/// Returns whether the whole line stays below the row `bottom` or above the row `top`: then it
/// crosses nothing between the two.
bool lineMisses(const Frame& frame, const ContactLayout& layout, float top, float bottom);

/// The highest and the lowest pixel row that a curve of the frame reaches now, for each column of
/// the plot.
struct CurveRows {
  float left = 0;  // of the first column
  std::vector<float> highest, lowest;

  /// Returns whether the curve passes through the rows of the box.
  bool crosses(const Box& box) const;
};
CurveRows curveRows(const Frame& frame, const std::vector<double>& heights,
                    const ContactLayout& layout);

/// Returns the left end of a box that is moved sideways from `preferred` as little as possible,
/// within `from` to `to`, so that it is above the curve now; none where there is no such position.
std::optional<float> freeSpanAbove(const CurveRows& curve, const Box& preferred, float from,
                                   float to);

enum class Body { Rigid, Elastomer };

/// Returns whether a label in the box lies on the body and not on the other one: always while the
/// line slides by, or at least now.
bool isOnBody(Body body, const Frame& frame, const ContactLayout& layout, const Box& box);

}  // namespace asperity
