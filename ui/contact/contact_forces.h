// The forces on the rigid line as two arrows from one point, in scale. Private to ui/contact; pure.
#pragma once

#include <optional>

#include "ui/contact/contact_layout.h"

namespace asperity {

/// Pixels. The normal force points down; friction points against the motion and is drawn
/// `enlarged` times as long for its force: coefficients of friction are as small as the slopes, so
/// that in one scale it would be a dot. The factor belongs to the line's slopes, not to the moment:
/// while friction changes, so does its arrow. sideways / down = mu * enlarged,
/// with mu in total.
struct ForceArrows {
  float down = 0;      // 0: no force, or no room for arrows
  float sideways = 0;  // 0: no friction, or too little of it for an arrow
  double enlarged = 1;
  bool pointsRight = false;
};
/// Whether the friction force on the line points to the right: against the motion, but for moments
/// after a stop or a reversal, when contact is still on the other side.
bool pushesRight(const Frame& frame);

/// top: of the arrows, pixels; with it they are shorter, or none, where they would lie across the
/// line of a low picture, now or while it slides by.
ForceArrows forceArrows(const Frame& frame, const ContactLayout& layout,
                        std::optional<float> top = {});

/// The point from which both arrows begin, at the right of the plot.
Place footOf(const ForceArrows& arrows, const ContactLayout& layout, float top);

/// Rims belong under the line, which they would cut, and arrows over it.
struct ForceLayers {
  DrawLayer &rims, &arrows;
};

/// From `from`, over the rigid body.
void addForceArrows(ForceLayers layers, const ForceArrows& arrows, Place from,
                    const ContactLayout& layout);

/// m/s, now; 0 without a scene.
double velocityOf(const Frame& frame);

/// Of what is drawn: of the steady state or, while the picture is still on its way there and of any
/// other motion, of this moment.
ContactState drawnState(const Frame& frame);

/// Whether local friction stands beside that of the deformation.
bool hasInterface(const Frame& frame);

/// The friction coefficient with the interface's part.
double totalFriction(const ContactState& state);

/// N, magnitude; with the interface's part: what acts on the line.
double frictionForce(const ContactState& state);

}  // namespace asperity
