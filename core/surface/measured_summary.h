// A measured surface in numbers, as a person who opens its file wants to know it: what the reader
// took the file for, the values of ISO 21920-2 before and after processing, its spectrum and how
// far that can be trusted, and what became of it as a line. In the file's own orientation, summits
// up. Pure; any thread. Failure: InputError as LineSource.
#pragma once

#include <nlohmann/json_fwd.hpp>
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
  std::int64_t rowsLeftOut = 0;
  ProcessedProfile profile{};  // that row
  ProfileParameters raw{}, used{};
  bool isRoughness = false;  // a long-wave cut makes the values used R parameters
  double longWaveCut = 0;    // m; 0: none
  SpectralDensity rawSpectrum{}, usedSpectrum{};  // under a Hann window, C1 two-sided
  ReliableBand band{};
  double period = 0;      // m, of the line
  double lineSlope = 0;   // rms, of the line that slides
  double slopeRatio = 1;  // of the isotropic equivalent over the surface as measured
  bool isEquivalent = false, hasTurned = false, isMirrored = false;
  NoteSet notes{};
};

/// `source` has the scene's lines, which are of a measured surface.
MeasuredSummary measuredSummary(const Scene& scene, const LineSource& source);

/// What the file was taken for and what was done to it, one sentence each.
std::vector<Message> factsOf(const MeasuredSummary& summary);

struct NamedValue {
  std::string name;  // "Pq"; of the used profile with a long-wave cut "Rq"
  std::string unit;  // "m" or empty
  double raw = 0, used = 0;
};
/// In the order of ISO 21920-2. The raw values are P parameters always.
std::vector<NamedValue> namedValues(const MeasuredSummary& summary);

/// "reading", "values", "spectrum_of_surface" and "notes".
void addTo(nlohmann::ordered_json& root, const MeasuredSummary& summary);

}  // namespace asperity
