// One moment of the simulation, as the picture needs it. Immutable once made; handed over by
// shared_ptr<const Frame>, read by any thread.
//
// Geometry, in the elastomer's frame: material point i rests at x_i = i * spacing, 0 <= i < n, one
// period. Heights are measured upwards from the undeformed surface of the elastomer, which fills
// everything below `surfaceHeight` (u <= 0); the rigid body fills everything above `lineHeight`
// (z - d). For v > 0 the rigid line moves towards +x. Both arrays are periodic.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/friction/curve_point.h"
#include "core/run/transient_sample.h"
#include "core/scene/scene.h"

namespace asperity {

/// What a frame holds only where it is asked for, because most pictures do without.
struct FrameFields {
  bool lineSlope = false, sinceContact = false, power = false;

  bool operator==(const FrameFields&) const = default;
  FrameFields operator|(const FrameFields& other) const {
    return {lineSlope || other.lineSlope, sinceContact || other.sinceContact, power || other.power};
  }
};

/// Forces and contact at one moment.
struct ContactState {
  double indentation = 0;      // m, d above the line's lowest point
  double normalForce = 0;      // N
  double tangentialForce = 0;  // N, magnitude along the motion; NaN as mu
  double contactFraction = 0;
  double mu = kNotApplicable;  // NaN where the time steps or elements are too coarse to read it
  double muInterface = 0;      // of local friction, beside mu
};

struct Frame {
  std::shared_ptr<const Scene> scene;  // the scene that made it; labels come from here
  std::uint64_t sceneNumber = 0;       // of the scene, as returned by Runner::post
  std::uint64_t step = 0;              // time steps made since the scene was reset
  double time = 0;                     // s simulated
  double distance = 0;                 // m slid
  double timeScale = 0;                // simulated seconds per second on screen
  double nextStep = 0;                 // s, of a motion: a moment nearer than that is this one
  double velocity = 0;                 // m/s, now; below 0 the line goes back

  double length = 0;                  // m, period
  double spacing = 0;                 // m between points
  std::vector<double> lineHeight;     // m, z - d
  std::vector<double> surfaceHeight;  // m, u
  std::vector<double> pressure;       // N/m, line load p >= 0; 0 where not in contact

  // On request (FrameFields), else empty; at the same points.
  std::vector<double> lineSlope;     // dz/dx of the rigid line over each element, not a difference
  std::vector<double> sinceContact;  // s since the element was last in contact, 0 in contact,
                                     // infinite where that was never seen
  std::vector<double> power;         // W/m, dissipated in the element's dashpots and, where it
                                     // touches, by local friction

  // Facts of the steady state of this line and scene; of motions that are not steady, of now.
  double indentation = 0;      // m, d above the line's lowest point
  double normalForce = 0;      // N
  double tangentialForce = 0;  // N, magnitude along the motion
  double contactFraction = 0;
  double rmsHeight = 0, rmsSlope = 0;  // of the line

  /// Of the time march over the steps since the last frame; NaN where its steps or its elements are
  /// too coarse to read friction from, or nothing moves.
  double muMarch = kNotApplicable;
  /// Estimated error of muMarch by its discretization, of a motion that is not steady; NaN where it
  /// is not known.
  double muError = kNotApplicable;
  /// Of the steady state of this very line and scene, from the steady pass; NaN where none exists.
  double muSteady = kNotApplicable;
  double muInterface = 0;  // of local friction, beside either

  /// The march, and with it the picture, is still on its way from the scene before to the steady
  /// state that the facts are of. `drawn` then has the facts of the picture.
  bool isSettling = false;
  ContactState drawn;

  /// N/m, greatest line load of the steady state: the end of a colour scale that does not depend on
  /// what was shown before. 0: not known, as of other motions.
  double steadyPressure = 0;

  /// What happened since the motion began; null in steady sliding.
  std::shared_ptr<const std::vector<TransientSample>> transient;
};

}  // namespace asperity
