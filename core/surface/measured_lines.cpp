#include "core/surface/measured_lines.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <numbers>
#include <numeric>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/base/stop.h"
#include "core/measured/profile_flaws.h"
#include "core/surface/random_phases.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kMinPoints = 3;

[[noreturn]] void fail(const char* key, const Message& what) {
  throw InputError("", key, what);
}

PrintedNumber printedLength(double length) {
  return printed(length, "m", 6);
}

/// The state of a file when it was read.
struct FileState {
  fs::path name{};
  std::uintmax_t size = 0;
  fs::file_time_type time{};

  static FileState of(const fs::path& file) {
    std::error_code error;
    return {fs::absolute(file, error), fs::file_size(file, error),
            fs::last_write_time(file, error)};
  }
  bool operator==(const FileState&) const = default;
};

/// Keeps the value made last for as long as its key stays the same.
template <class Key, class Value>
class LastOne {
 public:
  template <class Make>
  std::shared_ptr<const Value> get(const Key& key, const Make& make) {
    {
      const std::lock_guard guard(lock_);
      if (value_ && key_ == key) return value_;
    }
    std::shared_ptr<const Value> made = make();
    const std::lock_guard guard(lock_);
    key_ = key;
    value_ = made;
    return made;
  }

 private:
  std::mutex lock_;
  Key key_{};
  std::shared_ptr<const Value> value_;
};

ReadingChoices choicesOf(const SurfaceReading& reading) {
  return {reading.format,
          reading.positionUnit,
          reading.heightUnit,
          static_cast<int>(reading.positionColumn),
          static_cast<int>(reading.heightColumn),
          reading.pointSpacing};
}

MeasuredFile readFile(const Scene& scene, const std::stop_token& stop,
                      const ReadingProgress& progress) {
  const SurfaceReading& reading = scene.surface.reading;
  MeasuredFile file =
      readMeasuredFile(scene.folder / scene.surface.file, choicesOf(reading), stop, progress);
  if (reading.direction == ProfileDirection::AlongY) {
    if (file.topography.isProfile())
      fail("surface.direction",
           "across the rows (along_y) needs a topography; the file has a single profile");
    if (file.topography.rowSpacing == 0)
      fail("surface.direction",
           "across the rows (along_y) needs their distance, which the file does not state");
    file.topography = transposed(file.topography);
  }
  return file;
}

/// Returns the part of a scene that determines the lines, without what only determines their
/// evaluation.
Surface withoutEvaluation(Surface surface) {
  surface.elements = 0;
  return surface;
}

}  // namespace

std::shared_ptr<const MeasuredFile> readMeasuredSurface(const Scene& scene,
                                                        const std::stop_token& stop,
                                                        const ReadingProgress& progress) {
  using Key = std::tuple<FileState, ReadingChoices, ProfileDirection>;
  static LastOne<Key, MeasuredFile> last;
  const SurfaceReading& reading = scene.surface.reading;
  const Key key{FileState::of(scene.folder / scene.surface.file), choicesOf(reading),
                reading.direction};
  return last.get(
      key, [&] { return std::make_shared<const MeasuredFile>(readFile(scene, stop, progress)); });
}

std::shared_ptr<const MeasuredLines> MeasuredLines::of(const Scene& scene,
                                                       const std::stop_token& stop,
                                                       const ReadingProgress& progress) {
  using Key = std::tuple<FileState, Surface>;
  static LastOne<Key, MeasuredLines> last;
  const Key key{FileState::of(scene.folder / scene.surface.file), withoutEvaluation(scene.surface)};
  // Reading is the first half of the work where a spectrum of the whole surface follows.
  const bool hasMore = scene.surface.line == LineKind::IsotropicEquivalent ||
                       scene.surface.processing.seam == Seam::RandomPhases;
  const ReadingProgress ofReading = [&](double part) {
    if (progress) progress(hasMore ? 0.5 * part : part);
  };
  const ReadingProgress ofLines = [&](double part) {
    if (progress) progress(0.5 + 0.5 * part);
  };
  return last.get(key, [&] {
    return std::make_shared<const MeasuredLines>(scene, readMeasuredSurface(scene, stop, ofReading),
                                                 stop, ofLines);
  });
}

std::int64_t rowOfRealization(std::int64_t realization, std::int64_t realizations,
                              std::int64_t rows) {
  if (realizations == 0 || realizations >= rows) return realization % rows;
  return realization % realizations * rows / realizations;
}

MeasuredLines::MeasuredLines(const Scene& scene, std::shared_ptr<const MeasuredFile> file,
                             const std::stop_token& stop, const ReadingProgress& progress)
    : surface_(scene.surface), file_(std::move(file)) {
  chooseRows(scene);
  chooseInterval(scene);
  const double spacing = file_->topography.columnSpacing;
  const ProcessingChoices& processing = surface_.processing;
  for (const auto& [key, cut] : {std::pair{"surface.short_wave_cut", processing.shortWaveCut},
                                 std::pair{"surface.long_wave_cut", processing.longWaveCut}})
    if (cut > 0 && cut < 2 * spacing)
      fail(key, message("{} m is less than two points of the file, which are {} m apart",
                        plain(cut), plain(spacing)));
  if (processing.shortWaveCut > 0)
    shortWaves_.emplace(usedPoints_, spacing, processing.shortWaveCut);
  if (processing.longWaveCut > 0) longWaves_.emplace(usedPoints_, spacing, processing.longWaveCut);
  transform_.emplace(periodPoints_);
  // Only the form is removed here: the filters act equally on a row and on its equivalent line.
  if (surface_.line == LineKind::IsotropicEquivalent && file_->topography.rowSpacing > 0 &&
      file_->topography.rows >= kMinPoints)
    equivalent_ = equivalentSpectra(filledRows(stop), processing.form, stop, progress);
  throwIfStopped(stop);
  if (processing.seam == Seam::RandomPhases) setDensity(stop);
}

/// Chooses the rows that become lines, and refuses gaps where the scene does.
void MeasuredLines::chooseRows(const Scene& scene) {
  const Topography& topography = file_->topography;
  const std::int64_t asked = scene.surface.reading.row;
  if (asked > topography.rows)
    fail("surface.row",
         topography.rows == 1
             ? message("{} is outside 0 to 1; the file has a single profile", asked)
             : message("{} is outside 0 to {}, the rows of the file", asked, topography.rows));
  for (std::int64_t row = 0; row < topography.rows; ++row) {
    if (asked > 0 && row != asked - 1) continue;
    const std::span<const double> heights = topography.row(row);
    const std::int64_t gaps = gapCount(heights);
    const bool hasTooFew = topography.columns - gaps < kMinPoints;
    if (hasTooFew && asked > 0)
      fail("surface.row", message("row {} has {} measured points; a line needs {} or more", asked,
                                  topography.columns - gaps, kMinPoints));
    if (gaps > 0 && surface_.processing.gaps == GapHandling::Refuse) {
      if (hasTooFew && topography.rows > 1)
        fail("surface.gaps", message("row {} has {} measured points; interpolate leaves such rows "
                                     "out and fills the gaps of the others",
                                     row + 1, topography.columns - gaps));
      const auto index =
          std::ranges::find_if(heights, [](double z) { return std::isnan(z); }) - heights.begin();
      if (gaps == 1)
        fail("surface.gaps",
             message("row {} has no height at point {}; interpolate fills it", row + 1, index + 1));
      fail("surface.gaps", message("row {} has {} points without a height, the first is point {}; "
                                   "interpolate fills them",
                                   row + 1, gaps, index + 1));
    }
    if (hasTooFew)
      ++leftOut_;
    else
      rows_.push_back(row);
  }
  if (rows_.empty())
    fail("surface.file", message("has no row with {} measured points or more", kMinPoints));
  const std::int64_t realizations = scene.ensemble.realizations;
  if (asked > 0 || hasRandomPhases(scene.surface) || realizations <= rows()) return;
  if (leftOut_ > 0)
    fail("ensemble.realizations",
         message("{} is more than the rows of the file with {} measured points or more, which are "
                 "{} of {}; 0 is every one of them",
                 realizations, kMinPoints, rows(), topography.rows));
  fail("ensemble.realizations",
       rows() == 1
           ? message("{} is more than the single profile of the file; 0 is every row", realizations)
           : message("{} is more than the {} rows of the file; 0 is every row", realizations,
                     rows()));
}

/// Chooses the part of each row that is used: all of it, without gaps at the ends of a single
/// profile, or as much as the period of the scene needs.
void MeasuredLines::chooseInterval(const Scene& scene) {
  const Topography& topography = file_->topography;
  const double spacing = topography.columnSpacing;
  usedPoints_ = static_cast<std::size_t>(topography.columns);
  if (topography.isProfile()) {
    const std::span<const double> heights = topography.row(0);
    while (std::isnan(heights[firstPoint_])) ++firstPoint_;
    while (std::isnan(heights[usedPoints_ - 1])) --usedPoints_;
    usedPoints_ -= firstPoint_;
    missing_.ends = topography.columns - static_cast<std::int64_t>(usedPoints_);
  }
  const ProcessingChoices& processing = surface_.processing;
  const bool mirrors = processing.seam == Seam::Mirror, blends = processing.seam == Seam::Blend;
  double blend = blends ? processing.blendLength : 0;
  const double there = static_cast<double>(usedPoints_) * spacing;
  // The default is a tenth of the profile, and for a shorter period a tenth of what it needs.
  if (const double period = scene.surface.length; period > 0) {
    if (blends && blend == 0) blend = period / 9;
    const double wanted = mirrors ? period / 2 : period + blend;
    const double points = std::round(wanted / spacing);
    if (points > static_cast<double>(usedPoints_))
      fail("surface.length",
           message("{} is more than the period of {} that the file gives with this seam",
                   printedLength(period), printedLength(mirrors ? 2 * there : there - blend)));
    if (points < static_cast<double>(kMinPoints))
      fail("surface.length",
           message("{} has less than {} points of the file", printedLength(period), kMinPoints));
    usedPoints_ = static_cast<std::size_t>(points);
  } else if (blends && blend == 0) {
    blend = there / 10;
  }
  usedLength_ = static_cast<double>(usedPoints_) * spacing;
  if (blends) {
    blendPoints_ = static_cast<std::size_t>(std::max(1.0, std::round(blend / spacing)));
    if (2 * blendPoints_ > usedPoints_)
      fail("surface.blend_length", message("{} is more than half of the profile, which is {} long",
                                           printedLength(blend), printedLength(usedLength_)));
  }
  periodPoints_ = mirrors ? 2 * usedPoints_ : usedPoints_ - blendPoints_;
  if (periodPoints_ < static_cast<std::size_t>(kMinPoints))
    fail("surface.seam", message("leaves a period of {} points; at least {} are needed",
                                 periodPoints_, kMinPoints));
  length_ = static_cast<double>(periodPoints_) * spacing;
}

std::vector<double> MeasuredLines::usedHeights(std::int64_t row) const {
  const auto heights =
      file_->topography.row(rows_[static_cast<std::size_t>(row)]).subspan(firstPoint_, usedPoints_);
  return {heights.begin(), heights.end()};
}

/// Goes over all rows that are used, when one of the numbers is asked for the first time.
void MeasuredLines::countPoints() const {
  std::call_once(arePointsCounted_, [this] {
    const ProcessingChoices& processing = surface_.processing;
    missing_.rowsLeftOut = leftOut_;
    for (std::int64_t row = 0; row < rows(); ++row) {
      std::vector<double> heights = usedHeights(row);
      missing_.gaps += gapCount(heights);
      missing_.outliers += markOutliers(heights, processing.outliers, processing.form);
      spikes_ += spikeCount(heights, processing.form);
    }
  });
}

MissingHeights MeasuredLines::missingHeights() const {
  countPoints();
  return missing_;
}

std::int64_t MeasuredLines::spikes() const {
  countPoints();
  return spikes_;
}

SpectrumLimits MeasuredLines::spectrumLimits(const ProcessedProfile& profile) const {
  const ProcessingChoices& processing = surface_.processing;
  std::vector<double> levelled = profile.raw;
  markOutliers(levelled, processing.outliers, processing.form);
  interpolateGaps(levelled);
  removeForm(levelled, processing.form);
  SpectrumLimits limits{coarseSteps(profile.raw), {}};
  limits.band = reliableBand(levelled, profile.spacing, processing.shortWaveCut, limits.steps);
  // A cut-off that ends the band removes what the steps add.
  constexpr double kRounded = 1.01;
  if (kRounded * processing.shortWaveCut * limits.band.to >= 2 * std::numbers::pi)
    limits.steps = {};
  return limits;
}

/// Examines a few rows, spread evenly: steps are those of the instrument, and rows are much alike.
CoarseRows MeasuredLines::coarseRows() const {
  std::call_once(areStepsFound_, [this] {
    constexpr std::int64_t kMaxRows = 64;
    coarseRows_.examined = std::min(rows(), kMaxRows);
    for (std::int64_t i = 0; i < coarseRows_.examined; ++i) {
      const std::int64_t row = rowOfRealization(i, coarseRows_.examined, rows());
      if (coarseSteps(usedHeights(row)).step > 0 && spectrumLimits(profile(row)).steps.step > 0)
        ++coarseRows_.coarse;
    }
  });
  return coarseRows_;
}

/// Examines a few rows, spread evenly, without their outliers: one damaged row decides nothing.
double MeasuredLines::radiusOfForm() const {
  std::call_once(isFormFound_, [this] {
    // What a parabola leaves of a circle has waves of half the length, of which a cut-off of a
    // quarter of the length leaves a sixth (ISO 16610-21).
    constexpr double kRemoves = 0.25;
    const ProcessingChoices& processing = surface_.processing;
    if (longWaves_ && processing.longWaveCut <= kRemoves * usedLength_) return;
    constexpr std::int64_t kMaxRows = 5;
    const std::int64_t count = std::min(rows(), kMaxRows);
    std::vector<double> radii;  // 0 where a row is no circle
    for (std::int64_t i = 0; i < count; ++i) {
      std::vector<double> heights = usedHeights(rowOfRealization(i, count, rows()));
      markOutliers(heights, processing.outliers, processing.form);
      radii.push_back(radiusOfRoundForm(heights, file_->topography.columnSpacing));
    }
    const auto middle = radii.begin() + (std::ssize(radii) - 1) / 2;
    std::ranges::nth_element(radii, middle);
    radiusOfForm_ = *middle;
  });
  return radiusOfForm_;
}

ProcessedProfile MeasuredLines::profile(std::int64_t row) const {
  const ProcessingChoices& processing = surface_.processing;
  ProcessedProfile profile;
  profile.spacing = file_->topography.columnSpacing;
  profile.raw = usedHeights(row);
  profile.used = profile.raw;
  profile.gaps = gapCount(profile.used);
  profile.outliers = markOutliers(profile.used, processing.outliers, processing.form);
  if (profile.gaps == static_cast<std::int64_t>(usedPoints_))
    fail("surface.length", message("row {} has no measured point within {} m", numberInFile(row),
                                   plain(usedLength_)));
  interpolateGaps(profile.used);
  removeForm(profile.used, processing.form);
  if (shortWaves_) profile.used = shortWaves_->meanLine(profile.used);
  if (longWaves_) {
    const std::vector<double> waviness = longWaves_->meanLine(profile.used);
    for (std::size_t i = 0; i < waviness.size(); ++i) profile.used[i] -= waviness[i];
  }
  return profile;
}

std::vector<double> MeasuredLines::period(const ProcessedProfile& profile) const {
  std::vector<double> period = profile.used;
  switch (surface_.processing.seam) {
    case Seam::Mirror:
      period.insert(period.end(), profile.used.rbegin(), profile.used.rend());
      break;
    case Seam::Blend:
      // The end blends into the beginning with weights whose sum is 1, so that every height lies
      // between the two. A raised cosine has no corner at either end.
      period.resize(periodPoints_);
      for (std::size_t i = 0; i < blendPoints_; ++i) {
        const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(blendPoints_);
        const double weight = 0.5 - 0.5 * std::cos(std::numbers::pi * part);
        period[i] = weight * period[i] + (1 - weight) * profile.used[periodPoints_ + i];
      }
      break;
    default:
      break;
  }
  return period;
}

bool MeasuredLines::hasSeamJump(const ProcessedProfile& profile) const {
  constexpr double kOfSteps = 4;
  if (surface_.processing.seam != Seam::Periodic) return false;
  const std::vector<double>& z = profile.used;
  double square = 0;
  for (std::size_t i = 1; i < z.size(); ++i) square += (z[i] - z[i - 1]) * (z[i] - z[i - 1]);
  const double rms = std::sqrt(square / static_cast<double>(z.size() - 1));
  return std::abs(z.front() - z.back()) > kOfSteps * rms;
}

/// Returns the used parts of all rows for the spectrum of the surface, with gaps and outliers
/// interpolated.
Topography MeasuredLines::filledRows(const std::stop_token& stop) const {
  const Topography& all = file_->topography;
  Topography part{
      static_cast<std::int64_t>(usedPoints_), all.rows, all.columnSpacing, all.rowSpacing, {}};
  const ProcessingChoices& processing = surface_.processing;
  std::vector<double> before;  // stands for a row without any measured point
  for (std::int64_t row = 0; row < all.rows; ++row) {
    throwIfStopped(stop);
    const auto heights = all.row(row).subspan(firstPoint_, usedPoints_);
    std::vector<double> filled(heights.begin(), heights.end());
    markOutliers(filled, processing.outliers, processing.form);
    if (gapCount(filled) == static_cast<std::int64_t>(filled.size()))
      filled = before.empty() ? std::vector<double>(usedPoints_, 0.0) : before;
    interpolateGaps(filled);
    part.height.insert(part.height.end(), filled.begin(), filled.end());
    before = std::move(filled);
  }
  return part;
}

namespace {

/// Scales powers under a Hann window so that their sum is the mean square height of the rows. The
/// window mixes the first waves with the mean height and weighs the middle of the row, and so
/// changes the sum by the power of these waves alone: they are scaled, and the short waves keep
/// their power, and with it the slope.
void giveHeight(std::vector<double>& powers, double height) {
  constexpr std::size_t kMixed = 2;  // waves below the band that a spectrum describes
  const auto sumFrom = [&powers](std::size_t first) {
    return std::accumulate(powers.begin() + static_cast<std::ptrdiff_t>(first), powers.end(), 0.0);
  };
  const std::size_t first = std::min<std::size_t>(1, powers.size());
  const std::size_t end = std::min(first + kMixed, powers.size());
  const double kept = sumFrom(end), mixed = sumFrom(first) - kept;
  for (std::size_t k = first; k < end; ++k)
    powers[k] *= mixed > 0 ? std::max(height - kept, 0.0) / mixed : 0;
  // Where the others alone are too much, or none of the first waves has power, all are scaled.
  const double sum = sumFrom(first);
  for (double& power : powers) power *= sum > 0 ? height / sum : 0;
}

}  // namespace

/// Computes the mean spectrum of the rows in bands, from which random lines are made.
void MeasuredLines::setDensity(const std::stop_token& stop) {
  constexpr std::int64_t kMaxRows = 512;  // more of them change the mean little
  const std::int64_t count = std::min(rows(), kMaxRows);
  std::vector<double> powers;
  double height = 0;  // mean square of the rows
  for (std::int64_t i = 0; i < count; ++i) {
    throwIfStopped(stop);
    const ProcessedProfile one = profile(rowOfRealization(i, count, rows()));
    const std::vector<double> powersOfRow = hannPowers(one.used);
    powers.resize(powersOfRow.size());
    double mean = 0;
    for (const double z : one.used) mean += z / static_cast<double>(one.used.size());
    for (const double z : one.used)
      height += (z - mean) * (z - mean) /
                static_cast<double>(one.used.size() * static_cast<std::size_t>(count));
    for (std::size_t k = 1; k < powersOfRow.size(); ++k)
      powers[k] += powersOfRow[k] / static_cast<double>(count);
  }
  giveHeight(powers, height);
  BandPowers bands = inBands(powers, usedLength_);
  const double slope = bands.rmsSlope(), powerBefore = bands.total();
  if (surface_.line == LineKind::IsotropicEquivalent) {
    const EquivalentSpectra spectra = equivalent_ ? *equivalent_ : equivalentSpectra(bands);
    for (std::size_t j = 0; j < bands.bands(); ++j) {
      const double factor = spectra.factor(bands.centre(j));
      bands.power[j] *= factor * factor;
    }
  }
  densityRatios_ = {powerBefore > 0 ? std::sqrt(bands.total() / powerBefore) : 1,
                    slope > 0 ? bands.rmsSlope() / slope : 1};
  density_ = bands.density();
}

FourierLine MeasuredLines::modes(std::int64_t number) const {
  FourierLine line;
  line.length = length_;
  const double lowest = 2 * std::numbers::pi / length_;
  const std::size_t count = modeCount(periodPoints_);
  if (surface_.processing.seam == Seam::RandomPhases) {
    // A sum of random waves looks the same from both sides, so no side needs to be chosen.
    std::vector<double> magnitudes = modeMagnitudes(density_, length_, count);
    line.coefficients.resize(count);
    randomModes(static_cast<std::uint64_t>(surface_.seed), static_cast<std::uint64_t>(number),
                magnitudes, line.coefficients);
    return line;
  }
  line = measuredModes(number);
  if (surface_.line == LineKind::AsMeasured) return line;
  // One profile needs the Abel relation, applied to the same waves that are then strengthened.
  EquivalentSpectra ofProfile;
  if (!equivalent_) {
    std::vector<double> powers{0};
    for (const std::complex<double>& c : line.coefficients) powers.push_back(2 * std::norm(c));
    ofProfile = equivalentSpectra(inBands(powers, length_));
  }
  const EquivalentSpectra& spectra = equivalent_ ? *equivalent_ : ofProfile;
  for (std::size_t j = 0; j < line.coefficients.size(); ++j)
    line.coefficients[j] *= spectra.factor(lowest * static_cast<double>(j + 1));
  return line;
}

FourierLine MeasuredLines::measuredModes(std::int64_t row) const {
  FourierLine line = transform_->analyse(period(profile(row)), length_);
  if (surface_.contactSide == ContactSide::Summits)
    for (std::complex<double>& c : line.coefficients) c = -c;
  return line;
}

EquivalentRatios MeasuredLines::equivalentRatios() const {
  if (surface_.line == LineKind::AsMeasured) return {};
  if (surface_.processing.seam == Seam::RandomPhases) return densityRatios_;
  const FourierLine measured = measuredModes(0), equivalent = modes(0);
  const double height = rmsHeight(measured), slope = rmsSlope(measured);
  return {height > 0 ? rmsHeight(equivalent) / height : 1,
          slope > 0 ? rmsSlope(equivalent) / slope : 1};
}

}  // namespace asperity
