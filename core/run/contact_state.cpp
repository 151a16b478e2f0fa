#include "core/run/contact_state.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/chart/curve_regions.h"
#include "core/material/element_law.h"
#include "core/run/contact_tables.h"

namespace asperity {
namespace {

PrintedNumber coefficient(double mu) {
  return printed(mu, 3, Zeros::Keep);
}

/// Returns the velocity at this moment, m/s; above 0 the line moves to the right.
double velocityOf(const Frame& frame) {
  return frame.transient ? frame.velocity : frame.scene->sliding.velocity;
}

/// Returns how the rigid line moves.
Message motionInWords(const Frame& frame) {
  const double velocity = velocityOf(frame);
  const PrintedNumber speed = printed(std::abs(velocity), "m/s");
  if (frame.transient) {
    const PrintedNumber time = printed(frame.time, "s");
    if (velocity == 0) return message("At {} of the motion the rigid line rests.", time);
    return velocity > 0 ? message("At {} of the motion the rigid line slides to the right at {}.",
                                  time, speed)
                        : message("At {} of the motion the rigid line slides to the left at {}.",
                                  time, speed);
  }
  if (velocity == 0) return message("The rigid line rests.");
  return velocity > 0 ? message("The rigid line slides to the right at {}.", speed)
                      : message("The rigid line slides to the left at {}.", speed);
}

/// Returns where the bodies touch. The contact spots are those of the picture.
Message touchInWords(const Frame& frame, const ContactState& state) {
  const std::vector<ContactInterval> contacts = findIntervals(frame, false);
  if (contacts.empty()) return message("The bodies do not touch.");
  if (state.contactFraction >= 1) return message("All of the surface is in contact.");
  double longest = 0;
  for (const ContactInterval& contact : contacts) longest = std::max(longest, contact.length);
  const PrintedNumber part = printedPercent(state.contactFraction),
                      period = printed(frame.length, "m"), length = printed(longest, "m");
  // Between two nodes the picture may have a point more or fewer than the steady state.
  if (contacts.size() == 1)
    return message("They touch at one contact of {}, which is {} % of the period of {}.",
                   printed(state.contactFraction * frame.length, "m"), part, period);
  return message("They touch at {} contacts, {} % of the period of {}; the longest contact is {}.",
                 contacts.size(), part, period, length);
}

/// Returns what friction is and where it comes from.
Message frictionInWords(const Frame& frame, const ContactState& state) {
  const bool isElastic = elementLaw(frame.scene->elastomer).kind() == ElementKind::Elastic;
  if (!(state.normalForce > 0)) return message("Without a normal force there is no friction.");
  if (velocityOf(frame) == 0 && !frame.transient)
    return message("At rest there is no friction here.");
  if (!std::isfinite(state.mu))
    return message("Friction cannot be read here: elements or time steps are too coarse for it.");
  if (hasLocalFriction(*frame.scene)) {
    if (isElastic)
      return message("The coefficient of friction is {}, all of it from the interface.",
                     coefficient(state.muInterface));
    return message(
        "The coefficient of friction is {}: {} from the deformation of the elastomer and {} from "
        "the interface.",
        coefficient(state.mu + state.muInterface), coefficient(state.mu),
        coefficient(state.muInterface));
  }
  if (isElastic)
    return message(
        "There is no friction: an elastic body gives back all the work of its deformation.");
  return message(
      "The coefficient of friction is {}: a tangential force of {}, all of it from the deformation "
      "of the elastomer.",
      coefficient(state.mu), printed(std::abs(state.tangentialForce), "N"));
}

/// Returns the friction of other lines by the friction curve; empty where it is not known.
Message curveInWords(const CurveAtVelocity& curve) {
  Message mean, region;
  // All lines agree where they are the same line, except for rounding.
  constexpr double kRounding = 1e-5;
  const double share = std::abs(curve.error / curve.mu);
  if (curve.lines > 1 && std::isfinite(curve.mu) && share > kRounding)
    mean = message("The mean of {} lines is {} ± {} %.", curve.lines, coefficient(curve.mu),
                   printedPercent(share, 1));
  if (!curve.region.empty())
    region = message("This is region {} of the friction curve, {}.", curve.region,
                     Message(regionWord(curve.region)));
  return sentences({mean, region});
}

}  // namespace

std::vector<Message> describeContact(const Frame& frame, const CurveAtVelocity& curve) {
  if (!frame.scene) return {};
  const ContactState& state = frame.drawn();
  std::vector<Message> text;
  text.push_back(motionInWords(frame));
  text.push_back(message("It presses with {}; its lowest point is {} below the undeformed surface.",
                         printed(state.normalForce, "N"), printed(state.indentation, "m")));
  text.push_back(touchInWords(frame, state));
  text.push_back(frictionInWords(frame, state));
  if (Message of = curveInWords(curve); !of.empty()) text.push_back(std::move(of));
  if (frame.isSettling)
    text.push_back(
        std::isfinite(frame.state.mu)
            ? message("The picture still moves to the steady state, whose coefficient is {}.",
                      coefficient(frame.state.mu))
            : message("The picture still moves to the steady state."));
  for (const Note note : curve.notes.list())
    text.push_back(message("Note: {}.", noteSentence(note)));
  return text;
}

}  // namespace asperity
