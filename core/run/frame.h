// The state of the simulation at one time, as pictures need it, and the samples of a motion up to
// that time. Immutable once made; passed on by shared_ptr<const Frame>, read by any thread.
//
// Geometry, in the elastomer's frame: material point i rests at x_i = i * spacing, 0 <= i < n, one
// period. Heights are measured upwards from the undeformed surface of the elastomer, which fills
// everything below `surfaceHeight` (u <= 0); the rigid body fills everything above `lineHeight` (z
// - d). For v > 0 the rigid line moves towards +x. Both arrays are periodic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/contact/steady_sliding.h"
#include "core/friction/curve_point.h"
#include "core/friction/law.h"
#include "core/scene/scene.h"

namespace asperity {

/// Optional values of a frame, which are computed only on request, because most pictures do not use
/// them.
struct FrameFields {
  bool lineSlope = false, sinceContact = false, power = false;

  bool operator==(const FrameFields&) const = default;
  FrameFields operator|(const FrameFields& other) const {
    return {lineSlope || other.lineSlope, sinceContact || other.sinceContact, power || other.power};
  }
};

/// One sample of a motion that is not steady: means over the steps since the previous sample.
/// Here the tangential force has a sign: it is the integral of p z' dx = -F_x, with the sign of the
/// velocity where it resists, also at rest while contact is still one-sided. mu is its magnitude
/// over the normal force, NaN without one; muInterface is 0 at rest.
struct TransientSample : ContactState {
  double time = 0;                  // s, at its end
  double velocity = 0;              // m/s, mean; below 0 the line moves backwards
  double distance = 0;              // m, slid so far
  double muError = kNotApplicable;  // estimated discretization error; NaN where it is unknown
  double powerDissipated = 0;       // W, in the dashpots of all elements
  double contactSpots = 0;
  double contactLength = 0;  // m, mean of one contact spot
  /// 1/s, rate at which friction is expected to relax: 1 / tau + |v| / contactLength. Exact to
  /// about 1 % for one contact of Kelvin elements at constant force after a small change of
  /// velocity; approximate otherwise. NaN at rest and for elements of another kind than Kelvin's.
  double predictedRate = kNotApplicable;
};

struct Frame {
  std::shared_ptr<const Scene> scene;  // its scene, which also gives the labels
  std::uint64_t sceneNumber = 0;       // number of the scene, as returned by Runner::post
  std::uint64_t step = 0;              // number of time steps since the scene was reset
  double time = 0;                     // s simulated
  double distance = 0;                 // m slid
  double timeScale = 0;                // simulated seconds per second on screen
  double nextStep = 0;  // s, in a motion: a time closer than this belongs to this frame
  double velocity = 0;  // m/s, at present; below 0 the line moves backwards

  double length = 0;                  // m, period
  std::int64_t elements = 0;          // of the line, per period; points may be more
  double spacing = 0;                 // m between points
  std::vector<double> lineHeight;     // m, z - d
  std::vector<double> surfaceHeight;  // m, u
  std::vector<double> pressure;       // N/m, line load p >= 0; 0 where not in contact

  // Optional values (FrameFields) at the same points; otherwise empty.
  // dz/dx of the rigid line over each element, not a finite difference
  std::vector<double> lineSlope;
  // s since the element was last in contact: 0 in contact, infinite if never
  std::vector<double> sinceContact;
  // W/m, dissipated by the element's dashpots and, in contact, by local friction
  std::vector<double> power;

  double rmsHeight = 0, rmsSlope = 0;  // of the line

  /// The steady state of this line and scene, from the steady pass; for other motions, of the
  /// present time.
  ContactState state{};
  /// Estimated discretization error of the friction of a motion; NaN where it is unknown.
  double muError = kNotApplicable;
  /// Friction of the time march in steady sliding, over the steps since the last frame; NaN where
  /// its steps or its elements are too coarse for friction.
  double muMarch = kNotApplicable;

  /// Whether the march, and with it the picture, is still moving from the previous scene to the
  /// steady state. `marched` then has the values of the picture.
  bool isSettling = false;
  ContactState marched{};  // tangentialForce is NaN where mu is

  /// N/m, greatest line load of the steady state: the maximum of a colour scale that does not
  /// depend on earlier pictures. 0: unknown, as for other motions. NaN: contact lies between the
  /// points, whose pressures are not those of the contact.
  double steadyPressure = 0;

  /// The history since the motion began; null in steady sliding.
  std::shared_ptr<const std::vector<TransientSample>> transient;
  /// Samples of the same motion after this time, made before the user went back; null: none.
  std::shared_ptr<const std::vector<TransientSample>> later;

  /// Returns the state that is drawn: the steady state or, while the picture is still on its way
  /// there and for any other motion, the state at this time.
  const ContactState& drawn() const { return isSettling ? marched : state; }
};

/// Returns the normal force (N) of line loads (N/m) at points with this spacing (m).
inline double normalForce(std::span<const double> lineLoads, double spacing) {
  double force = 0;
  for (const double load : lineLoads) force += load * spacing;
  return force;
}

/// Returns dz/dx of the rigid line at a point; of a frame without slopes the central difference of
/// the heights.
inline double lineSlopeAt(const Frame& frame, std::size_t point) {
  const std::size_t n = frame.lineHeight.size();
  if (frame.lineSlope.size() == n) return frame.lineSlope[point];
  const double rise = frame.lineHeight[(point + 1) % n] - frame.lineHeight[(point + n - 1) % n];
  return rise / (2 * frame.spacing);
}

/// Returns the input of Eqs. (13) and (14) for the line in a frame, at a velocity (m/s).
inline LawInput lawInput(const Frame& frame, double velocity) {
  const Scene& scene = *frame.scene;
  return lawInput(elementLaw(scene.elastomer), {frame.rmsHeight, frame.rmsSlope}, frame.length,
                  scene.surface.hurst, frame.state.normalForce, velocity);
}

}  // namespace asperity
