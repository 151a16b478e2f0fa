// What to simulate, as plain values. A Scene is copied freely and never shared for writing; any
// thread may own one. The member initialisers below are the only source of defaults. Ranges,
// labels and units of the members stand in parameters.cpp, one row each.
// All values are SI: metres, pascals, seconds, newtons.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/material/elastomer.h"
#include "core/measured/processing_choices.h"

namespace asperity {

enum class SurfaceKind { SelfAffine, Sine, Wedge, Parabola, Profile, Measured, Spectrum };
enum class LoadKind { Force, Indentation, Pressure };
enum class SlidingKind { Steady, Start, Step, Oscillation, Reversal };
enum class Scheme { Nodal, Linear, Cubic };

/// What the numbers of a measured spectrum mean (core/surface/spectrum_file.h).
enum class SpectrumKind { Unstated, C1TwoSided, C1OneSided, C2 };

/// How the file of a measured surface is read. The words are those of
/// core/measured/measured_file.h.
struct SurfaceReading {
  std::string format = "auto";
  std::string positionUnit = "auto", heightUnit = "auto";
  std::int64_t positionColumn = 0, heightColumn = 0;  // counted from 1; 0: found by the reader
  double pointSpacing = 0;  // m, where the file does not say how far its points are apart; 0: as it
                            // says
  std::int64_t row = 0;     // counted from 1; 0: all rows
  ProfileDirection direction = ProfileDirection::AlongX;

  bool operator==(const SurfaceReading&) const = default;
};

/// The rigid line: one period, repeated for ever.
struct Surface {
  SurfaceKind kind = SurfaceKind::SelfAffine;
  double length = 0.02;          // m, one period; 0 where the line has a file: as it says
  std::int64_t elements = 5000;  // per period; 0 where the line has a file: as many as it has
  double hurst = 0.7;            // Hurst exponent H
  double rmsHeight = 5e-7;       // m, h (ISO Rq)
  std::int64_t seed = 1;         // of the random phases
  double amplitude = 5e-7;       // m, of a sine
  std::int64_t waves = 8;        // of a sine, per period
  double slope = 1e-3;           // of a wedge z = slope |x|
  double radius = 0.1;           // m, of a parabola z = x^2 / (2 radius)
  std::string file;              // of kinds that have one, relative to the scene's folder
  double rollOffWavelength = 0;  // m, waves longer than it are all equally strong; 0: none
  double summitCorrelation =
      0;                   // kappa, short waves stronger on the summits (> 0); 0: equal everywhere
  SurfaceReading reading;  // of a measured surface
  ProcessingChoices processing;  // of a measured surface; its two cuts of a spectrum, too
  LineKind line = LineKind::AsMeasured;
  ContactSide contactSide = ContactSide::Summits;
  SpectrumKind spectrumKind = SpectrumKind::Unstated;  // of a spectrum; there is no default

  bool operator==(const Surface&) const = default;
};

struct Load {
  LoadKind kind = LoadKind::Force;
  double normalForce = 0.0034;   // N, F_N on one period
  double depth = 1e-6;           // m, indentation d below the lowest point of the line
  double nominalPressure = 1e5;  // Pa, on the area of one period and the width
  double width = 0;              // m, across the line; 0: as much as the period

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
  // It depends on the velocity: shearStress exp(-c log10^2(a_T v / v_0)).
  double shearVelocity = 0;  // m/s, v_0, where it is largest; 0: no dependence
  double shearWidth = 0.1;   // c

  bool operator==(const Interface&) const = default;
};

/// How the values of a sweep are spaced: evenly in their logarithm, or evenly.
enum class SweepScale { Logarithmic, Linear };

/// The key of velocity, over which a friction curve goes unless its scene names another one.
inline constexpr std::string_view kVelocityKey = "sliding.velocity";

/// The horizontal axis of a friction curve: x_i = from (to / from)^(i / (points - 1)), or from +
/// (to - from) i / (points - 1). Any number of the table of parameters (core/scene/sweep.h); over
/// another one than velocity, the states slide at `sliding.velocity`.
struct Sweep {
  double velocityFrom = 1e-5;  // m/s, of velocity alone
  double velocityTo = 1e3;     // m/s, likewise
  std::int64_t points = 41;
  std::string key{kVelocityKey};
  double from = 0, to = 0;  // of another key, in its unit; `from` may be above `to`
  SweepScale scale = SweepScale::Logarithmic;

  bool isOfVelocity() const { return key == kVelocityKey; }

  bool operator==(const Sweep&) const = default;
};

/// The theories that may be drawn beside a friction curve (core/friction/theory_curve.h).
enum class Theory { Eq11, GaussianFoundation, CompleteContact, PerssonHalfSpace };

/// A table of measured friction (core/fit/friction_data.h).
struct DataFile {
  std::string file;   // relative to the scene's folder
  std::string label;  // in legends; empty: the file's name

  bool operator==(const DataFile&) const = default;
};

/// The comparisons beside the friction curve.
struct Comparisons {
  std::vector<DataFile> data;
  std::vector<Theory> theory{Theory::Eq11};

  bool operator==(const Comparisons&) const = default;
};

struct Ensemble {
  std::int64_t realizations = 200;  // 0 for the rows of a measured surface: every row

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
  Comparisons comparison;

  /// The folder of the scene's file, to which the files that it names are relative. It is not
  /// written to the file.
  std::filesystem::path folder;

  bool operator==(const Scene&) const = default;
};

/// Returns the width (m) of the contact across a line of this period (m): that of a nominal
/// pressure, where it has one, else the period.
inline double contactWidth(const Load& load, double length) {
  return load.kind == LoadKind::Pressure && load.width > 0 ? load.width : length;
}

/// Returns the load on a line of this period (m): a nominal pressure as the force that follows from
/// it, F_N = p_0 L width; any other load is unchanged.
inline Load loadOn(const Load& load, double length) {
  Load same = load;
  if (load.kind != LoadKind::Pressure) return same;
  same.kind = LoadKind::Force;
  same.normalForce = load.nominalPressure * length * contactWidth(load, length);
  return same;
}

/// Returns whether the line comes from a file: surface.file names it.
inline bool hasSurfaceFile(const Surface& surface) {
  return surface.kind == SurfaceKind::Profile || surface.kind == SurfaceKind::Measured ||
         surface.kind == SurfaceKind::Spectrum;
}

/// Returns whether the line is rough: a sum of waves of many lengths, random or from a file. Other
/// lines have the simple shape of a formula.
inline bool isRough(const Surface& surface) {
  return surface.kind == SurfaceKind::SelfAffine || hasSurfaceFile(surface);
}

/// Returns the number of waves in the period below which the spectrum of a self-affine line is
/// flat; 0 without a roll-off.
inline double rollOffMode(const Surface& surface) {
  return surface.rollOffWavelength > 0 ? surface.length / surface.rollOffWavelength : 0;
}

/// Returns whether the phases of the line's waves are random, so that there are any number of
/// lines.
inline bool hasRandomPhases(const Surface& surface) {
  return surface.kind == SurfaceKind::SelfAffine || surface.kind == SurfaceKind::Spectrum ||
         (surface.kind == SurfaceKind::Measured && surface.processing.seam == Seam::RandomPhases);
}

/// Returns whether lines may be rows of a topography.
inline bool mayHaveRows(const Surface& surface) {
  return surface.kind == SurfaceKind::Measured && surface.reading.row == 0 &&
         !hasRandomPhases(surface);
}

/// Returns whether results are means over several lines: random ones, or all rows of a measured
/// surface, which may turn out to have only one.
inline bool mayHaveManyLines(const Surface& surface) {
  return hasRandomPhases(surface) || mayHaveRows(surface);
}

/// Returns whether the scene has local friction in contact in addition to that of the deformation.
inline bool hasLocalFriction(const Scene& scene) {
  return scene.interface.frictionCoefficient > 0 || scene.interface.shearStress > 0;
}

/// Returns whether resolution and number of lines follow from a target accuracy.
inline bool choosesAccuracy(const Scene& scene) {
  return scene.accuracy.scheme == Scheme::Cubic && scene.accuracy.targetRelativeError > 0;
}

/// The size of one period of a line; 0 where unknown.
struct LineSize {
  double length = 0;  // m
  std::int64_t elements = 0;

  bool operator==(const LineSize&) const = default;
};

/// Returns the points per element of one line: of a picture, a motion, a profile. It is the number
/// that the scene states or else the program chooses; the paper's separate elements have one point
/// each. A motion that costs little has more points, if the size of its line is known. With a
/// target accuracy it is the number that a single state of the line needs.
std::int64_t pointsPerElement(const Scene& scene, const LineSize& line);

/// Returns the same for a line whose size the scene states. Where the line of a motion has its size
/// from a file, call linePoints (core/surface/line_source.h).
std::int64_t pointsPerElement(const Scene& scene);

/// Returns whether the points per element depend on a size that only the surface's file has.
bool needsSizeOfFile(const Scene& scene);

/// Returns the points per element of the lines of a friction curve, chosen so that the error of the
/// resolution stays below half of the standard error. A curve to a target accuracy does not use it,
/// because it chooses at each velocity.
std::int64_t curvePointsPerElement(const Scene& scene);

/// Sets the resolution of a friction curve that the scene leaves to the program, so that it does
/// not change with other parameters.
void fixResolution(Scene& scene);

}  // namespace asperity
