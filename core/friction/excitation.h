// Which frequencies of the elastomer a sliding line excites: its wave of wave number q deforms the
// elastomer at w = q v. In complete contact mu F_N = 2 L integral q C1(q) 4 G''(q v) dq, so a
// decade of frequencies counts by q^2 C1(q) G''(q v); the same weights are taken for partial
// contact. From them follow the band that friction rests on, and whether it was measured. Pure
// after construction; any thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/material/element_law.h"
#include "core/scene/notes.h"
#include "core/scene/scene.h"

namespace asperity {

class LineSource;

/// Hz.
struct FrequencyRange {
  double from = 0, to = 0;
};

/// The frequencies below which lie 5, 50 and 95 % of the weight.
struct ExcitedBand {
  double from = 0, median = 0, to = 0;  // Hz
};

/// Friction is called extrapolated where more than this share of the weight was not measured.
inline constexpr double kMostNotMeasured = 0.1;

/// The frequencies at which the elastomer of the scene was measured, as they are at its
/// temperature: those at the reference over a_T. Nothing where they are not known.
std::optional<FrequencyRange> measuredFrequencies(const Elastomer& elastomer);

/// Whether the elastomer is at a temperature at which it was not measured.
bool isAtForeignTemperature(const Elastomer& elastomer);

/// Whether so large a share of the weight rests on what was not measured; false for NaN.
bool isExtrapolated(double shareNotMeasured);

/// What to know of an elastomer on these lines: frequencies, temperature and strains at which it
/// was not measured. Strains are about as large as the slopes.
NoteSet elastomerNotes(const Elastomer& elastomer, const LineSource& source,
                       double shareNotMeasured);
/// The same for lines of this rms slope.
NoteSet elastomerNotes(const Elastomer& elastomer, double rmsSlope, double shareNotMeasured);

/// Modes of neighbouring wave numbers together.
struct WaveBand {
  double waveNumber = 0;  // 1/m
  double strength = 0;    // sum of q |c_q|^2
  double decades = 0;     // of wave number that it covers
};

/// The waves of the first line of a source. Making them takes as long as making the line; any
/// number of elastomers may share them, and lines that differ in height, which is a factor on all.
using ExcitedWaves = std::shared_ptr<const std::vector<WaveBand>>;
ExcitedWaves excitedWaves(const LineSource& source);

class Excitation {
 public:
  /// Uses the scene's first line; elastomer and load may be any.
  Excitation(const Scene& scene, const LineSource& source);
  Excitation(const Elastomer& elastomer, ExcitedWaves waves);

  /// Nothing where nothing is dissipated: at rest, without roughness, in an elastic body.
  std::optional<ExcitedBand> band(double velocity) const;

  /// Share of the weight at frequencies that were not measured; NaN where these are not known, or
  /// nothing is dissipated.
  double shareNotMeasured(double velocity) const;

  /// Weight per decade of frequency over its largest value, at rising frequencies (Hz).
  struct Weight {
    double frequency = 0, weight = 0;
  };
  std::vector<Weight> weights(double velocity) const;

 private:
  ExcitedWaves waves_;
  ElementLaw law_;
  std::optional<FrequencyRange> measured_;
};

/// Makes the first line of a scene and returns its excitation.
Excitation computeExcitation(const Scene& scene);

}  // namespace asperity
