// What to simulate, as plain values. A Scene is copied freely and never shared for writing; any
// thread may own one. The member initialisers below are the only source of defaults. Ranges,
// labels and units of the members stand in parameters.cpp, one row each.
// All values are SI: metres, pascals, seconds, newtons.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/material/elastomer.h"

namespace asperity {

enum class SurfaceKind { SelfAffine, Sine, Wedge, Parabola, Profile };
enum class LoadKind { Force, Indentation };
enum class SlidingKind { Steady, Start, Step, Oscillation, Reversal };
enum class Scheme { Nodal, Linear, Cubic };

/// The rigid line: one period, repeated for ever.
struct Surface {
  SurfaceKind kind = SurfaceKind::SelfAffine;
  double length = 0.02;          // m, one period; 0 for a profile: as its file says
  std::int64_t elements = 5000;  // per period; 0 for a profile: one for each of its rows
  double hurst = 0.7;            // Hurst exponent H
  double rmsHeight = 5e-7;       // m, h (ISO Rq)
  std::int64_t seed = 1;         // of the random phases
  double amplitude = 5e-7;       // m, of a sine
  std::int64_t waves = 8;        // of a sine, per period
  double slope = 1e-3;           // of a wedge z = slope |x|
  double radius = 0.1;           // m, of a parabola z = x^2 / (2 radius)
  std::string file;              // of a profile, relative to the scene's folder
  double rollOffWavelength = 0;  // m, waves longer than it are all equally strong; 0: none
  double summitCorrelation = 0;  // kappa, short waves stronger on the summits (> 0); 0: everywhere

  bool operator==(const Surface&) const = default;
};

struct Load {
  LoadKind kind = LoadKind::Force;
  double normalForce = 0.0034;  // N, F_N on one period
  double depth = 1e-6;          // m, indentation d below the lowest point of the line

  bool operator==(const Load&) const = default;
};

/// v(t) for 0 <= t <= duration, from the steady state at `velocity`; `start` from static
/// equilibrium at v = 0.
struct Sliding {
  SlidingKind kind = SlidingKind::Steady;
  double velocity = 1.0;       // m/s; of an oscillation: its mean
  double velocityAfter = 2.0;  // m/s, of a step, from half of the duration on
  double amplitude = 0.5;      // m/s, of an oscillation
  double frequency = 100;      // Hz, of an oscillation
  double duration = 0.04;      // s, of all but steady sliding

  bool operator==(const Sliding&) const = default;
};

/// Local friction in contact, beside what the deformation costs: one of the two, or none.
struct Interface {
  double frictionCoefficient = 0;  // tangential over normal line load
  double shearStress = 0;          // N/m, tangential line load in contact

  bool operator==(const Interface&) const = default;
};

/// The velocities of a friction curve: v_i = from (to / from)^(i / (points - 1)).
struct Sweep {
  double velocityFrom = 1e-5;  // m/s
  double velocityTo = 1e3;     // m/s
  std::int64_t points = 41;

  bool operator==(const Sweep&) const = default;
};

struct Ensemble {
  std::int64_t realizations = 200;

  bool operator==(const Ensemble&) const = default;
};

struct Accuracy {
  Scheme scheme = Scheme::Cubic;
  std::int64_t oversampling = 0;   // points per element; 0: chosen (core/scene/resolution.cpp)
  double targetRelativeError = 0;  // of mu; above 0 it chooses both and the realizations

  bool operator==(const Accuracy&) const = default;
};

struct Scene {
  std::string title;
  std::string description;  // what to look for
  std::string chapter;      // of the collection it belongs to
  Surface surface;
  Elastomer elastomer;
  Load load;
  Sliding sliding;
  Interface interface;
  Sweep sweep;
  Ensemble ensemble;
  Accuracy accuracy;

  /// Folder against which surface.file is resolved; where the scene was read, not part of it.
  std::filesystem::path folder;

  bool operator==(const Scene&) const = default;
};

/// Whether resolution and number of lines follow from a target accuracy.
inline bool choosesAccuracy(const Scene& scene) {
  return scene.accuracy.scheme == Scheme::Cubic && scene.accuracy.targetRelativeError > 0;
}

/// Points per element that resolve one line: of a picture, a motion, a profile. What the scene
/// states, or what is chosen for it; the paper's separate elements have one each. With a target
/// accuracy it is what a single state of the line needs for it.
std::int64_t pointsPerElement(const Scene& scene);

/// The same of the lines that a friction curve is averaged over: chosen so that the error of the
/// resolution stays below half of the standard error. A curve to a target accuracy does not use it,
/// because it chooses at each velocity.
std::int64_t pointsPerElementOfCurve(const Scene& scene);

}  // namespace asperity
