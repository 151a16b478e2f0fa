// What to simulate, as plain values. A Scene is copied freely and never shared for writing; any
// thread may own one. The member initialisers below are the only source of defaults. Ranges,
// labels and units of the members stand in parameters.cpp, one row each.
// All values are SI: metres, pascals, seconds, newtons.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace asperity {

enum class SurfaceKind { SelfAffine, Sine, Wedge, Parabola, Profile };
enum class Rheology { Elastic, Kelvin };
enum class LoadKind { Force, Indentation };
enum class SlidingKind { Steady };
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

  bool operator==(const Surface&) const = default;
};

struct Elastomer {
  Rheology rheology = Rheology::Kelvin;
  double shearModulus = 1e7;     // Pa, G
  double relaxationTime = 1e-3;  // s, tau = eta / G

  bool operator==(const Elastomer&) const = default;
};

struct Load {
  LoadKind kind = LoadKind::Force;
  double normalForce = 0.0034;  // N, F_N on one period
  double depth = 1e-6;          // m, indentation d below the lowest point of the line

  bool operator==(const Load&) const = default;
};

struct Sliding {
  SlidingKind kind = SlidingKind::Steady;
  double velocity = 1.0;  // m/s

  bool operator==(const Sliding&) const = default;
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
  std::int64_t oversampling = 2;  // nodes per element

  bool operator==(const Accuracy&) const = default;
};

struct Scene {
  std::string title;
  Surface surface;
  Elastomer elastomer;
  Load load;
  Sliding sliding;
  Sweep sweep;
  Ensemble ensemble;
  Accuracy accuracy;

  /// Folder against which surface.file is resolved; where the scene was read, not part of it.
  std::filesystem::path folder;

  bool operator==(const Scene&) const = default;
};

/// Points that resolve the line per element; the paper's separate elements have one each.
inline std::int64_t pointsPerElement(const Scene& scene) {
  return scene.accuracy.scheme == Scheme::Nodal ? 1 : scene.accuracy.oversampling;
}

}  // namespace asperity
