#include "ui/contact/contact_forces.h"

#include <cmath>

namespace asperity {

double frameVelocity(const Frame& frame) {
  if (frame.transient) return frame.velocity;
  return frame.scene ? frame.scene->sliding.velocity : 0;
}

bool hasInterface(const Frame& frame) {
  return frame.scene && hasLocalFriction(*frame.scene);
}

double totalFriction(const ContactState& state) {
  return state.mu + state.muInterface;
}

bool pushesRight(const Frame& frame) {
  const double force =
      frame.transient && !frame.transient->empty() ? frame.transient->back().tangentialForce : 0;
  return (force != 0 ? force : frameVelocity(frame)) < 0;
}

double frictionForce(const ContactState& state) {
  if (!(state.muInterface > 0)) return state.tangentialForce;
  return std::abs(totalFriction(state)) * state.normalForce;
}

}  // namespace asperity
