// The forces on the rigid line and its velocity, as the picture of a frame tells them. Private to
// ui/contact; pure.
#pragma once

#include "core/run/contact_state.h"

namespace asperity {

/// Returns whether the friction force on the line points to the right. It points against the
/// motion, except shortly after a stop or a reversal, when contact is still on the other side.
bool pushesRight(const Frame& frame);

/// Returns the present velocity, m/s; 0 without a scene.
double frameVelocity(const Frame& frame);

/// Returns whether there is local friction in addition to that of the deformation.
bool hasInterface(const Frame& frame);

/// Returns the friction coefficient including the interface's part.
double totalFriction(const ContactState& state);

/// Returns the magnitude of the friction force on the line, N, including the interface's part.
double frictionForce(const ContactState& state);

}  // namespace asperity
