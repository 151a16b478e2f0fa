// The lines of a measured surface: every row of its file, after all steps of processing, as one
// period of a band-limited line. Heights have the orientation of the file and point out of the
// surface; only modes() returns the rigid line of the model, which lies above the rubber.
// Ownership: immutable once made, and shared. The lines of the surface requested last are kept,
// because a scene's lines are made in many places. Threading: any thread.
// Failure: InputError for what the file or a choice states; StopRequested where `stop` was
// requested.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/measured/measured_file.h"
#include "core/measured/processing.h"
#include "core/measured/roughness_spectrum.h"
#include "core/scene/scene.h"
#include "core/surface/spectrum.h"

namespace asperity {

/// Reads the file of a scene's measured surface with the scene's choices, transposed where it
/// slides along y. The file read last is kept for as long as its size and time stay.
std::shared_ptr<const MeasuredFile> readMeasuredSurface(const Scene& scene,
                                                        const std::stop_token& stop = {},
                                                        const ReadingProgress& progress = {});

/// One row before and after its processing, without the seam.
struct ProcessedProfile {
  double spacing = 0;        // m
  std::vector<double> raw;   // m, the interval used, as in the file; NaN where nothing was measured
  std::vector<double> used;  // m
  std::int64_t gaps = 0, outliers = 0;  // points that were interpolated
};

/// What was not measured: rows of the file that are no lines, ends of a profile, and points that
/// are interpolated.
struct MissingHeights {
  std::int64_t rowsLeftOut = 0;         // with fewer than three measured points
  std::int64_t ends = 0;                // points at the ends of a single profile, left out
  std::int64_t gaps = 0, outliers = 0;  // points of the used parts of the used rows
};

/// The spectrum of a row as far as it can be relied on, and the steps of its heights where they are
/// too coarse and no cut-off removes what they add.
struct SpectrumLimits {
  HeightSteps steps{};
  ReliableBand band{};
};

/// Rows whose heights have such steps, among those examined: all, or some spread evenly.
struct CoarseRows {
  std::int64_t coarse = 0, examined = 0;
};

/// How the isotropic equivalent differs from the line as measured.
struct EquivalentRatios {
  double height = 1, slope = 1;  // of the rms values
};

class MeasuredLines {
 public:
  /// Makes the lines of the scene from a file that has been read; of() reads the scene's own file.
  /// `progress` is called with the finished part of the work, 0 to 1.
  MeasuredLines(const Scene& scene, std::shared_ptr<const MeasuredFile> file,
                const std::stop_token& stop = {}, const ReadingProgress& progress = {});
  static std::shared_ptr<const MeasuredLines> of(const Scene& scene,
                                                 const std::stop_token& stop = {},
                                                 const ReadingProgress& progress = {});

  const MeasuredFile& file() const { return *file_; }
  std::int64_t rows() const { return static_cast<std::int64_t>(rows_.size()); }  // that can be used
  /// Returns what was not measured of all rows that are used.
  MissingHeights missingHeights() const;

  double length() const { return length_; }                                         // m, the period
  std::int64_t points() const { return static_cast<std::int64_t>(periodPoints_); }  // of a period

  /// Returns row 0 ... rows() - 1 of the used ones before and after processing, without the seam.
  ProcessedProfile profile(std::int64_t row) const;
  /// Returns how many points of all rows are spikes (spikeCount) that the processing leaves in the
  /// line.
  std::int64_t spikes() const;
  SpectrumLimits spectrumLimits(const ProcessedProfile& profile) const;
  CoarseRows coarseRows() const;
  /// Returns the middle radius (m) of rows that are parts of circles (radiusOfRoundForm); 0 where
  /// half of them or more are none, or where a long-wave cut-off removes the form.
  double radiusOfForm() const;
  /// Returns the number of that row in the file, counted from 1.
  std::int64_t numberInFile(std::int64_t row) const {
    return rows_[static_cast<std::size_t>(row)] + 1;
  }

  /// Returns one period with its seam, summits up, of the surface as measured. Not for random
  /// phases.
  std::vector<double> period(const ProcessedProfile& profile) const;
  /// Returns whether the ends of the profile meet in a step that is larger than four times the rms
  /// step between neighbours. Only `periodic` makes such a step.
  bool hasSeamJump(const ProcessedProfile& profile) const;
  bool mayHaveSeamJump() const { return surface_.processing.seam == Seam::Periodic; }

  /// Returns the modes of the rigid line of a row, up to the highest one that the points of the
  /// period can represent; with random phases, those of a realization.
  FourierLine modes(std::int64_t number) const;

  /// Returns the modes of a row as measured, whatever line the scene asks for. Not for random
  /// phases.
  FourierLine measuredModes(std::int64_t row) const;
  /// Returns the rms values of the first isotropic equivalent over those of the same line as
  /// measured; 1 where the scene uses the line as measured. The equivalent has the height of the
  /// surface, which only the mean over its rows has, and which rows lose that are levelled one by
  /// one.
  EquivalentRatios equivalentRatios() const;
  /// Returns the density of the lines with random phases.
  const SpectralDensity& density() const { return density_; }

 private:
  void chooseRows(const Scene& scene);
  void chooseInterval(const Scene& scene);
  void setDensity(const std::stop_token& stop);
  std::vector<double> usedHeights(std::int64_t row) const;
  void countPoints() const;
  Topography filledRows(const std::stop_token& stop) const;

  Surface surface_;
  std::shared_ptr<const MeasuredFile> file_;
  std::vector<std::int64_t> rows_;
  std::int64_t leftOut_ = 0;
  std::size_t firstPoint_ = 0, usedPoints_ = 0, blendPoints_ = 0, periodPoints_ = 0;
  double length_ = 0, usedLength_ = 0;
  std::optional<GaussianFilter> shortWaves_, longWaves_;
  std::optional<EquivalentSpectra> equivalent_;  // of a topography
  SpectralDensity density_;
  EquivalentRatios densityRatios_;
  std::optional<FourierTransform> transform_;
  mutable std::once_flag arePointsCounted_;  // the next two have their values
  mutable MissingHeights missing_;
  mutable std::int64_t spikes_ = 0;
  mutable std::once_flag areStepsFound_;  // coarseRows_ has its values
  mutable CoarseRows coarseRows_;
  mutable std::once_flag isFormFound_;  // radiusOfForm_ has its value
  mutable double radiusOfForm_ = 0;
};

/// Returns the row of a realization out of `rows`: the rows are spread evenly, because neighbouring
/// rows are much alike. realizations: 0 for all rows.
std::int64_t rowOfRealization(std::int64_t realization, std::int64_t realizations,
                              std::int64_t rows);

}  // namespace asperity
