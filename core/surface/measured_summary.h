// A summary of a measured surface for the person who opens its file: how the file was understood,
// the parameters of ISO 21920-2 before and after processing, the spectrum and its reliable band,
// and the resulting line. Heights have the orientation of the file, summits up. Pure; any thread.
// Failure: InputError as LineSource.
#pragma once

#include <string>
#include <vector>

#include "core/measured/profile_parameters.h"
#include "core/scene/notes.h"
#include "core/surface/line_source.h"

namespace asperity {

struct MeasuredSummary {
  ReadingFacts facts{};
  std::int64_t columns = 0, rows = 0;        // of the file
  double spacing = 0, rowSpacing = 0;        // m
  std::int64_t rowInFile = 1, rowsUsed = 1;  // the row of realization 0; all that are lines
  MissingHeights missing{};
  ProcessedProfile profile{};  // that row
  ProfileParameters raw{}, used{};
  double longWaveCut = 0;                         // m; 0: none
  SpectralDensity rawSpectrum{}, usedSpectrum{};  // under a Hann window, C1 two-sided
  HeightSteps steps{};                            // of that row, where they are too coarse
  CoarseRows coarseRows{};                        // of all that are lines
  double radius = 0;  // m, of rows that are parts of circles (MeasuredLines::radiusOfForm); 0: none
  ReliableBand band{};
  bool isFlat = false;   // all heights of that row are the same
  double period = 0;     // m, of the line
  double lineSlope = 0;  // rms, of the line that slides
  EquivalentRatios ratios{};
  bool isEquivalent = false, hasTurned = false, isMirrored = false;
  std::int64_t spikes = 0;  // points of all rows (MeasuredLines::spikes)
  NoteSet notes{};

  /// Returns whether the values used are R parameters: a long-wave cut makes them so.
  bool isRoughness() const { return longWaveCut > 0; }
};

/// Whether a summary has both spectra, which only pictures and JSON show.
enum class SummarySpectra { Computed, Omitted };

/// Makes the summary. source: has the scene's lines, which are those of a measured surface.
MeasuredSummary measuredSummary(const Scene& scene, const LineSource& source,
                                SummarySpectra spectra = SummarySpectra::Computed);

/// Returns a sentence on the spikes of all rows, and on what removes them.
Message spikesFact(std::int64_t spikes);

/// Returns how the scene's file of a surface or of a spectrum was read: its kind, columns and
/// units, what the reader supposes and changes, and what is left out or interpolated; one sentence
/// each. Empty where the scene has no such file.
std::vector<Message> readingFacts(const Scene& scene);

/// Returns how the file was understood and processed, one sentence each.
std::vector<Message> factsOf(const MeasuredSummary& summary);

struct NamedValue {
  std::string name;  // "Pq"; of the used profile with a long-wave cut "Rq"
  std::string unit;  // "m" or empty
  double raw = 0, used = 0;
};
/// Returns the parameters in the order of ISO 21920-2. The raw values are always P parameters.
std::vector<NamedValue> namedValues(const MeasuredSummary& summary);

}  // namespace asperity
