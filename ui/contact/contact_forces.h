// The forces on the rigid line as two arrows from one point, to scale. Private to ui/contact; pure.
#pragma once

#include <optional>

#include "core/run/contact_state.h"
#include "ui/contact/contact_layout.h"

namespace asperity {

/// Lengths in pixels: sideways / down = mu * enlarged. The normal force points down. Friction
/// points against the motion, and its arrow is `enlarged` times as long relative to its force:
/// friction coefficients are as small as the slopes, so that at the same scale it would be a dot.
/// The factor follows from the slopes of the line and not from the friction, so that the arrow
/// changes with friction; it is divided by ten where the arrow would not fit into the picture.
struct ForceArrows {
  float down = 0;      // 0: no force, or no space for arrows
  float sideways = 0;  // 0: no friction, or too little for an arrow
  double enlarged = 1;
  bool pointsRight = false;
};

/// Returns whether the friction force on the line points to the right. It points against the
/// motion, except shortly after a stop or a reversal, when contact is still on the other side.
bool pushesRight(const Frame& frame);

/// Returns the arrows. top: of the arrows, pixels; with it they are shorter, or missing, where they
/// would lie across the line of a low picture, now or while it slides by.
ForceArrows forceArrows(const Frame& frame, const ContactLayout& layout,
                        std::optional<float> top = {});

/// Returns the point where both arrows begin, at the right of the plot.
DrawPoint arrowFoot(const ForceArrows& arrows, const ContactLayout& layout, float top);

/// Layers for rims, which are under the line, and for arrows, which are over it.
struct ForceLayers {
  DrawLayer &rims, &arrows;
};

/// Adds the arrows from `from`, over the rigid body.
void addForceArrows(ForceLayers layers, const ForceArrows& arrows, DrawPoint from,
                    const ContactLayout& layout);

/// Returns the present velocity, m/s; 0 without a scene.
double frameVelocity(const Frame& frame);

/// Returns whether there is local friction in addition to that of the deformation.
bool hasInterface(const Frame& frame);

/// Returns the friction coefficient including the interface's part.
double totalFriction(const ContactState& state);

/// Returns the magnitude of the friction force on the line, N, including the interface's part.
double frictionForce(const ContactState& state);

}  // namespace asperity
