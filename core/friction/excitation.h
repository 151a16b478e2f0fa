// The frequencies at which a sliding line excites the elastomer: its wave of wave number q deforms
// the elastomer at w = q v. In complete contact mu F_N = 2 L integral q C(q) 4 G''(q v) dq, so a
// decade of frequencies has the weight q^2 C(q) G''(q v); the same weights are used for partial
// contact. From them follow the band on which friction rests, and whether it was measured. Pure
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

/// The frequencies below which 5, 50 and 95 % of the weight lie.
struct ExcitedBand {
  double from = 0, median = 0, to = 0;  // Hz
};

/// Friction counts as extrapolated where a larger share of the weight was not measured.
inline constexpr double kMaxNotMeasured = 0.1;

/// Returns the frequencies at which the elastomer was measured, converted to its temperature: those
/// at the reference divided by a_T. Nothing where they are not known.
std::optional<FrequencyRange> measuredFrequencies(const Elastomer& elastomer);

/// Returns whether this share of the weight makes friction extrapolated; false for NaN.
bool isExtrapolated(double shareNotMeasured);

/// Returns the notes on an elastomer on lines of this rms slope: on frequencies, temperature and
/// strains outside of the measured range. Strains are about as large as the slopes.
NoteSet elastomerNotes(const Elastomer& elastomer, double rmsSlope, double shareNotMeasured);

/// The modes of a band of neighbouring wave numbers.
struct WaveBand {
  double waveNumber = 0;  // 1/m
  double strength = 0;    // sum of q |c_q|^2
  double decades = 0;     // of wave number that it covers
};

/// The waves of the first line of a source. Computing them takes as long as making the line. Any
/// number of elastomers may share them, and so may lines that differ by a factor in height.
using ExcitedWaves = std::shared_ptr<const std::vector<WaveBand>>;
ExcitedWaves excitedWaves(const LineSource& source);

class Excitation {
 public:
  /// Uses the scene's first line; elastomer and load are arbitrary.
  Excitation(const Scene& scene, const LineSource& source);
  Excitation(const Elastomer& elastomer, ExcitedWaves waves);

  /// Returns the excited band; nothing where nothing is dissipated: at rest, without roughness, in
  /// an elastic body. velocity: m/s.
  std::optional<ExcitedBand> band(double velocity) const;

  /// Returns the share of the weight at frequencies that were not measured; NaN where these are not
  /// known, or nothing is dissipated.
  double shareNotMeasured(double velocity) const;

  /// The weight per decade of frequency over its largest value, at rising frequencies (Hz).
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
