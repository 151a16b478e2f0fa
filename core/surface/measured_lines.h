// The lines of a measured surface: every row of its file, through all steps of processing, as one
// period of a band-limited line. Everything is said in the file's own orientation, heights pointing
// out of the surface, but for modes(), which is the rigid line of the model and lies above the
// rubber.
// Ownership: immutable once made, and shared: one is kept for the surface that was asked for last,
// because a scene's lines are made in many places. Threading: any thread.
// Failure: InputError for what the file or a choice says; StopRequested where `stop` was
// requested.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/measured/measured_file.h"
#include "core/measured/processing.h"
#include "core/measured/roughness_spectrum.h"
#include "core/scene/scene.h"
#include "core/surface/spectrum.h"

namespace asperity {

/// The file of a scene's measured surface, as its reading says; turned where it slides along y. The
/// last one read is kept for as long as size and time of the file stay.
std::shared_ptr<const MeasuredFile> readMeasuredSurface(const Scene& scene,
                                                        const std::stop_token& stop = {},
                                                        const ReadingProgress& progress = {});

/// One row before and after its processing; before the seam.
struct ProcessedProfile {
  double spacing = 0;        // m
  std::vector<double> raw;   // m, the stretch used, as in the file; NaN where nothing was measured
  std::vector<double> used;  // m
  std::int64_t gaps = 0, outliers = 0;  // points that were interpolated
};

class MeasuredLines {
 public:
  /// The lines of the scene, of a file that has been read, or of the scene's own. `progress` is
  /// told the part of all this that is done, 0 to 1.
  MeasuredLines(const Scene& scene, std::shared_ptr<const MeasuredFile> file,
                const std::stop_token& stop = {}, const ReadingProgress& progress = {});
  static std::shared_ptr<const MeasuredLines> of(const Scene& scene,
                                                 const std::stop_token& stop = {},
                                                 const ReadingProgress& progress = {});

  const MeasuredFile& file() const { return *file_; }
  std::int64_t rows() const { return static_cast<std::int64_t>(rows_.size()); }  // that can be used
  std::int64_t rowsLeftOut() const { return leftOut_; }  // with fewer than three measured points

  double length() const { return length_; }          // m, the period
  double lengthUsed() const { return usedLength_; }  // m, of the file
  std::int64_t points() const { return static_cast<std::int64_t>(periodPoints_); }  // of a period

  /// Row 0 ... rows() - 1 of those used, before and after. Counts no seam.
  ProcessedProfile profile(std::int64_t row) const;
  /// The number of that row in the file, counted from 1.
  std::int64_t numberInFile(std::int64_t row) const {
    return rows_[static_cast<std::size_t>(row)] + 1;
  }

  /// One period with its seam, summits up, of the surface as measured. Not of random phases.
  std::vector<double> period(const ProcessedProfile& profile) const;
  /// Whether the ends of the profile meet in a step: it is larger than four times the root mean
  /// square step between neighbours. Only `periodic` makes one.
  bool hasSeamJump(const ProcessedProfile& profile) const;
  bool mayHaveSeamJump() const { return surface_.processing.seam == Seam::Periodic; }

  /// The modes of the rigid line of a row, up to what the period's points carry. Of random phases:
  /// of a realization.
  FourierLine modes(std::int64_t number) const;

  /// The same as measured, whatever line the scene asks for. Not of random phases.
  FourierLine measuredModes(std::int64_t row) const;
  /// Rms slope of the isotropic equivalent over that of the line as measured; 1 where the line is
  /// as measured.
  double slopeRatio() const;
  /// Of random phases.
  const SpectralDensity& density() const { return density_; }

 private:
  void chooseRows(const Scene& scene);
  void chooseStretch(const Scene& scene);
  void setDensity(const std::stop_token& stop);
  std::vector<double> stretch(std::int64_t row) const;
  Topography stretches(const std::stop_token& stop) const;

  Surface surface_;
  std::shared_ptr<const MeasuredFile> file_;
  std::vector<std::int64_t> rows_;
  std::int64_t leftOut_ = 0;
  std::size_t firstPoint_ = 0, usedPoints_ = 0, blendPoints_ = 0, periodPoints_ = 0;
  double length_ = 0, usedLength_ = 0;
  std::optional<GaussianFilter> shortWaves_, longWaves_;
  std::optional<EquivalentSpectra> equivalent_;  // of a topography
  SpectralDensity density_;
  double densitySlopeRatio_ = 1;
  std::optional<FourierTransform> transform_;
};

/// The row for a realization of so many out of `rows`: spread evenly, because neighbouring rows are
/// much alike. `realizations` 0: all.
std::int64_t rowOfRealization(std::int64_t realization, std::int64_t realizations,
                              std::int64_t rows);

}  // namespace asperity
