#include "ui/contact/contact_forces.h"

#include <algorithm>
#include <cmath>

#include "ui/contact/label_placement.h"
#include "ui/draw/theme.h"
#include "ui/draw/ticks.h"

namespace asperity {
namespace {

constexpr float kMinPlot = 130;      // units; lower plots have no space
constexpr float kLowPlot = 300;      // units; in higher ones the line may pass behind arrows
constexpr float kClearance = 4;      // units, between an arrow's end and the line
constexpr float kShortestArrow = 5;  // units; a shorter one would vanish in the dot at its foot
constexpr double kTypicalFriction =
    0.5;  // of the plateau's mu; its arrow is about as long as that of F_N

/// Returns 1, 2 or 5 times a power of ten; on plateaus mu is about 1.4 times the rms slope.
double enlargementFor(double rmsSlope) {
  return rmsSlope > 0 ? std::max(1.0, roundUp125(kTypicalFriction / rmsSlope)) : 1;
}

void addArrowWithRim(ForceLayers layers, DrawPoint from, DrawPoint to,
                     const ContactLayout& layout) {
  const float u = layout.sizes.unit;
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  const float head = std::min(9 * u, 0.5F * length);
  addArrow(layers.rims, from, to, head, 6 * u, withAlpha(layout.theme.rigid, 0.85F));
  addArrow(layers.arrows, from, to, head, 2.8F * u, layout.theme.highlight);
}

}  // namespace

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

namespace {

ForceArrows arrowsInScale(const Frame& frame, const ContactLayout& layout) {
  ForceArrows arrows;
  const ContactState state = drawnState(frame);
  const float u = layout.sizes.unit;
  if (!(state.normalForce > 0) || layout.plot.height < kMinPlot * u) return arrows;
  arrows.down = std::clamp(0.17F * layout.plot.height, 26 * u, 64 * u);
  const double mu = totalFriction(state);
  if (!(mu > 0) || !(frictionForce(state) > 0)) return arrows;
  arrows.pointsRight = pushesRight(frame);
  arrows.enlarged = enlargementFor(frame.rmsSlope);
  const double available = 0.3 * layout.plot.width / arrows.down;  // in lengths of the normal force
  while (arrows.enlarged > 1 && mu * arrows.enlarged > available)
    arrows.enlarged = std::max(1.0, arrows.enlarged / 10);
  if (mu * arrows.enlarged > available)
    arrows.down *= static_cast<float>(available / (mu * arrows.enlarged));
  arrows.sideways = static_cast<float>(mu * arrows.enlarged) * arrows.down;
  if (arrows.sideways < kShortestArrow * u) arrows.sideways = 0;
  return arrows;
}

}  // namespace

DrawPoint arrowFoot(const ForceArrows& arrows, const ContactLayout& layout, float top) {
  const float away = 3 * std::round(9 * layout.sizes.unit);
  return {layout.plot.right() - away - (arrows.pointsRight ? arrows.sideways : 0), top};
}

ForceArrows forceArrows(const Frame& frame, const ContactLayout& layout, std::optional<float> top) {
  const ForceArrows arrows = arrowsInScale(frame, layout);
  const float u = layout.sizes.unit;
  if (!top || !(arrows.down > 0) || layout.plot.height > kLowPlot * u) return arrows;
  for (const float part : {1.0F, 0.75F, 0.55F})
    if (lineStaysBelow(frame, layout, *top + part * arrows.down + kClearance * u)) {
      ForceArrows shorter = arrows;
      shorter.down *= part;
      shorter.sideways *= part;
      return shorter;
    }
  return {};
}

void addForceArrows(ForceLayers layers, const ForceArrows& arrows, DrawPoint from,
                    const ContactLayout& layout) {
  const float side = arrows.pointsRight ? arrows.sideways : -arrows.sideways;
  if (arrows.sideways > 0) addArrowWithRim(layers, from, {from.x + side, from.y}, layout);
  if (arrows.down > 0) addArrowWithRim(layers, from, {from.x, from.y + arrows.down}, layout);
  const float u = layout.sizes.unit;
  addLine(layers.arrows, {from}, 7 * u, layout.theme.highlight);
}

}  // namespace asperity
