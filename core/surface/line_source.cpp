#include "core/surface/line_source.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/scene/parameters.h"
#include "core/scene/plan.h"
#include "core/scene/provenance.h"
#include "core/surface/random_phases.h"
#include "core/surface/spectrum_file.h"

namespace asperity {
namespace {

constexpr std::int64_t kMaxNodes = std::int64_t{1} << 26;
constexpr std::int64_t kNodesOfProduct = 4;  // per element, of a product of waves: not aliased

/// Returns the result of `read` for the scene's file; errors name the key that names the file.
template <class Read>
auto readFile(const Scene& scene, const Read& read) {
  try {
    return read(scene.folder / scene.surface.file);
  } catch (const InputError& error) {
    throw InputError("", "surface.file", errorMessage(error));
  }
}

/// Returns the length (m) of a profile: that of the scene, or else that of the file's positions.
double profileLength(const Surface& surface, double lengthOfFile) {
  const double length = surface.length > 0 ? surface.length : lengthOfFile;
  if (length == 0)
    throw InputError("", "surface.length", "is missing; the profile has heights without positions");
  const Parameter& row = *findParameter("surface.length");
  const AllowedRange range = *allowedRange(row);
  if (length < range.minimum || length > range.maximum)
    throw InputError("", "surface.file",
                     message("{}: its length {} m is outside {}", surface.file, plain(length),
                             allowedText(row)));
  return length;
}

/// Returns the result of `read` for a measured surface; errors without a key are about its file.
template <class Read>
auto readMeasured(const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    if (!error.key().empty() && error.file().empty()) throw;
    throw InputError("", error.key().empty() ? "surface.file" : error.key(),
                     error.key().empty() ? errorMessage(error) : error.message());
  }
}

/// Returns the number of rows of a scene's means.
std::int64_t rowsUsed(const Scene& scene, const MeasuredLines& lines) {
  const std::int64_t realizations = scene.ensemble.realizations;
  return realizations > 0 && scene.surface.reading.row == 0 ? realizations : lines.rows();
}

std::shared_ptr<const MeasuredLines> measuredLines(const Scene& scene) {
  return readMeasured([&] { return MeasuredLines::of(scene); });
}

/// Returns a spectrum with the cut-offs of its scene.
SpectrumTable spectrumOf(const Scene& scene) {
  const SpectrumKind kind = scene.surface.spectrumKind;
  SpectrumTable table =
      readFile(scene, [kind](const auto& file) { return readSpectrumTable(file, kind); });
  const ProcessingChoices& cuts = scene.surface.processing;
  const double low = cuts.longWaveCut > 0 ? 2 * std::numbers::pi / cuts.longWaveCut : 0;
  const double high = cuts.shortWaveCut > 0 ? 2 * std::numbers::pi / cuts.shortWaveCut : HUGE_VAL;
  table.density = within(table.density, low, high);
  if (!(table.density.integral() > 0))
    throw InputError("", cuts.longWaveCut > 0 ? "surface.long_wave_cut" : "surface.short_wave_cut",
                     "leaves no wave of the spectrum");
  return table;
}

/// Returns a sentence on each end of the band of a spectrum where the waves of the line end
/// elsewhere.
std::vector<Message> bandFacts(const SpectralDensity& density, const LineExtent& extent) {
  constexpr double kEqual = 1.05;  // ratio of wavelengths
  const double longest = 2 * std::numbers::pi / density.waveNumber.front(),
               shortest = 2 * std::numbers::pi / density.waveNumber.back();
  const double longestOfLine = extent.length,
               shortestOfLine = 2 * extent.length / static_cast<double>(extent.elements);
  const auto metres = [](double length) { return printed(length, "m"); };
  std::vector<Message> facts;
  if (longestOfLine > kEqual * longest)
    facts.push_back(
        message("the spectrum ends at waves of {}: longer ones of the line, which is {} "
                "long, have no height",
                metres(longest), metres(longestOfLine)));
  if (kEqual * longestOfLine < longest)
    facts.push_back(
        message("the spectrum has waves up to {}: those longer than the line, which is "
                "{} long, are left out",
                metres(longest), metres(longestOfLine)));
  if (kEqual * shortestOfLine < shortest)
    facts.push_back(
        message("the spectrum ends at waves of {}: shorter ones, down to {} of {} "
                "elements, have no height",
                metres(shortest), metres(shortestOfLine), extent.elements));
  if (shortestOfLine > kEqual * shortest)
    facts.push_back(
        message("the spectrum has waves down to {}: those shorter than {} are left out, "
                "because {} elements do not represent them",
                metres(shortest), metres(shortestOfLine), extent.elements));
  return facts;
}

/// The period is the longest wave, and the elements represent the shortest one, unless the scene
/// states other values.
LineExtent spectrumExtent(const Surface& surface, const SpectralDensity& density) {
  constexpr double kMin = 16, kMax = 1 << 20;
  const double lowest = density.waveNumber.front(), highest = density.waveNumber.back();
  LineExtent extent{surface.length, surface.elements, 0, 0};
  if (extent.length == 0) extent.length = 2 * std::numbers::pi / lowest;
  const Parameter& row = *findParameter("surface.length");
  const AllowedRange range = *allowedRange(row);
  if (extent.length < range.minimum || extent.length > range.maximum)
    throw InputError("", "surface.length",
                     message("{} m, the longest wave of the spectrum, is outside {}",
                             plain(extent.length), allowedText(row)));
  if (extent.elements == 0) {
    const double waves = std::ceil(highest * extent.length / (2 * std::numbers::pi));
    extent.elements = static_cast<std::int64_t>(std::clamp(2 * waves + 1, kMin, kMax));
  }
  const auto modes =
      modeMagnitudes(density, extent.length, modeCount(static_cast<std::size_t>(extent.elements)));
  double square = 0;
  for (const double magnitude : modes) square += 2 * magnitude * magnitude;
  extent.rmsHeight = std::sqrt(square);
  if (!(square > 0))
    throw InputError("", "surface.length",
                     message("{} m with {} elements carries no wave of the spectrum, whose waves "
                             "are {:.4g} to {:.4g} m long",
                             plain(extent.length), extent.elements, 2 * std::numbers::pi / highest,
                             2 * std::numbers::pi / lowest));
  return extent;
}

void requireFewNodes(std::int64_t elements, std::int64_t oversampling) {
  if (elements * oversampling <= kMaxNodes) return;
  const std::int64_t mostOversampling = std::max<std::int64_t>(1, kMaxNodes / elements);
  throw InputError(
      "", "surface.elements",
      message("{} times oversampling {} is more than {} points; allowed are up to {} elements, or "
              "with accuracy.oversampling {} up to {}",
              elements, oversampling, kMaxNodes, kMaxNodes / oversampling, mostOversampling,
              kMaxNodes / mostOversampling));
}

}  // namespace

LineExtent lineExtent(const Scene& scene) {
  const Surface& surface = scene.surface;
  if (surface.kind == SurfaceKind::Spectrum) {
    LineExtent extent = spectrumExtent(surface, spectrumOf(scene).density);
    extent.lines = scene.ensemble.realizations;
    return extent;
  }
  if (surface.kind == SurfaceKind::Measured) {
    const auto lines = measuredLines(scene);
    const std::int64_t elements = surface.elements > 0 ? surface.elements : lines->points();
    return {lines->length(), elements, 0, rmsHeight(lines->modes(0)),
            hasRandomPhases(surface) ? scene.ensemble.realizations : rowsUsed(scene, *lines)};
  }
  if (surface.kind != SurfaceKind::Profile)
    return {surface.length, surface.elements, 0, surface.rmsHeight,
            surface.kind == SurfaceKind::SelfAffine ? scene.ensemble.realizations : 1};
  const ProfileExtent file = readFile(scene, profileExtent);
  return {profileLength(surface, file.length), surface.elements > 0 ? surface.elements : file.rows,
          file.rows, file.rmsHeight};
}

std::int64_t linePoints(const Scene& scene) {
  if (!needsSizeOfFile(scene)) return pointsPerElement(scene);
  const LineExtent extent = lineExtent(scene);
  return pointsPerElement(scene, {extent.length, extent.elements});
}

nlohmann::ordered_json lineProvenance(const std::string& verb, const Scene& scene) {
  nlohmann::ordered_json root = provenance(verb, scene);
  if (!needsSizeOfFile(scene) || !root["oversampling_used"].is_null()) return root;
  try {
    root["oversampling_used"] = linePoints(scene);
  } catch (const InputError&) {
    // The command that needs the line reports the error.
  }
  return root;
}

Profile readProfileStart(const Scene& scene, std::int64_t rows) {
  return readFile(scene, [rows](const auto& file) { return readProfileStart(file, rows); });
}

LineSource::LineSource(const Scene& scene, std::int64_t oversampling, const Profile* profile)
    : surface_(scene.surface), length_(surface_.length), elements_(surface_.elements) {
  isRandom_ = hasRandomPhases(surface_);
  if (isRandom_) lines_ = scene.ensemble.realizations;
  if (surface_.kind == SurfaceKind::Measured) setMeasured(scene);
  if (surface_.kind == SurfaceKind::Spectrum) setSpectrum(scene);
  if (surface_.kind == SurfaceKind::Profile)
    setProfile(profile ? *profile : readFile(scene, readProfile));
  requireFewNodes(elements_, oversampling);
  nodes_ = static_cast<std::size_t>(elements_ * oversampling);
  if (surface_.kind == SurfaceKind::Sine && surface_.waves > (elements_ - 1) / 2)
    throw InputError("", "surface.waves",
                     message("{} is outside 1 to {}, what {} elements carry", surface_.waves,
                             (elements_ - 1) / 2, elements_));
  if (surface_.kind == SurfaceKind::SelfAffine) setAmplitudes(scene);
  if (isRough(surface_)) transform_.emplace(nodes_);
  if (surface_.kind == SurfaceKind::Measured && !isRandom_) {
    profile_ = carried(measured_->modes(0));
  }
  if (isRandom()) {
    const FourierLine modes = spectrum(0);
    statistics_ = {rmsHeight(modes), rmsSlope(modes)};
  } else {
    if (transform_)
      setFromSpectrum(profile_, Slopes::Computed, only_, {});
    else
      only_ = makeShape();
    statistics_ = {only_.rmsHeight, only_.rmsSlope};
  }
}

/// Returns the modes that the elements can represent.
FourierLine LineSource::carried(FourierLine modes) const {
  const std::size_t most = modeCount(static_cast<std::size_t>(elements_));
  if (modes.coefficients.size() > most) modes.coefficients.resize(most);
  return modes;
}

/// The coefficient of exp(i q x) is half of the amplitude of the cosine.
void LineSource::setAmplitudes(const Scene& scene) {
  const bool rollsOff = needsStage(scene, Purpose::Surface, Stage::RollOff);
  if (rollsOff) countStage(Stage::RollOff);
  amplitudes_ =
      selfAffineAmplitudes(static_cast<std::size_t>(elements_), surface_.hurst, surface_.rmsHeight,
                           rollsOff ? length_ / surface_.rollOffWavelength : 0);
  if (needsStage(scene, Purpose::Surface, Stage::SummitCorrelation))
    summits_.emplace(static_cast<std::size_t>(elements_ * kNodesOfProduct));
  for (double& amplitude : amplitudes_) amplitude /= 2;
}

void LineSource::setProfile(const Profile& profile) {
  length_ = profileLength(surface_, profile.length);
  if (elements_ == 0) elements_ = static_cast<std::int64_t>(profile.height.size());
  profile_ = carried(FourierTransform(profile.height.size()).analyse(profile.height, length_));
}

void LineSource::setMeasured(const Scene& scene) {
  measured_ = measuredLines(scene);
  length_ = measured_->length();
  if (elements_ == 0) elements_ = measured_->points();
  if (hasRandomPhases(surface_)) {
    amplitudes_ = modeMagnitudes(measured_->density(), length_,
                                 modeCount(static_cast<std::size_t>(elements_)));
    return;
  }
  const std::int64_t rows = measured_->rows();
  lines_ = rowsUsed(scene, *measured_);
  isRandom_ = rows > 1;
  drawsRows_ = choosesAccuracy(scene);
}

void LineSource::setSpectrum(const Scene& scene) {
  const SpectrumTable table = spectrumOf(scene);
  const SpectralDensity& density = table.density;
  const LineExtent extent = spectrumExtent(surface_, density);
  length_ = extent.length;
  elements_ = extent.elements;
  amplitudes_ = modeMagnitudes(density, length_, modeCount(static_cast<std::size_t>(elements_)));
  spectrumFacts_ = table.facts;
  spectrumFacts_.push_back(
      density.binEdge.empty()
          ? Message("the spectrum is a power law between each two of its points")
          : Message("the wave numbers are whole multiples of one step, as of a periodogram: each "
                    "value of the spectrum is its mean over a step"));
  std::ranges::copy(bandFacts(density, extent), std::back_inserter(spectrumFacts_));
}

std::int64_t LineSource::rowOf(std::int64_t realization) const {
  if (!hasRows()) return 0;
  if (!drawsRows_) return rowOfRealization(realization, lines_, measured_->rows());
  // A target accuracy may need any number of lines, so rows are drawn with replacement.
  constexpr std::uint64_t kSeed = 1;
  const double turn =
      randomPhases(kSeed, static_cast<std::uint64_t>(realization), 0).even / (2 * std::numbers::pi);
  const auto row = static_cast<std::int64_t>(turn * static_cast<double>(measured_->rows()));
  return std::min(row, measured_->rows() - 1);
}

void LineSource::requireLines(std::int64_t lines, const std::string& option) const {
  if (lines > 1 && !isRandom())
    throw InputError("", option, "this surface has one line, and no other realization");
  if (hasRows() && lines > rowsToUse())
    throw InputError(
        "", option,
        message("{} is more than {}, the number of rows that the scene uses", lines, rowsToUse()));
}

void LineSource::requireRealization(std::int64_t realization, const std::string& option) const {
  if (realization < 0) throw InputError("", option, "is below 0");
  if (hasRows() && realization >= rowsToUse())
    throw InputError("", option,
                     message("{} is outside 0 to {}, the rows that the scene uses", realization,
                             rowsToUse() - 1));
  if (realization > 0) requireLines(2, option);
}

FourierLine LineSource::spectrum(std::int64_t number) const {
  FourierLine line;
  spectrumInto(line, number);
  return line;
}

void LineSource::spectrumInto(FourierLine& line, std::int64_t number) const {
  if (!isRandom()) {
    line = profile_;
    return;
  }
  if (measured_ && !hasRandomPhases(surface_)) {
    line = carried(measured_->modes(rowOf(number)));
    return;
  }
  line.length = length_;
  line.coefficients.resize(amplitudes_.size());
  randomModes(static_cast<std::uint64_t>(surface_.seed), static_cast<std::uint64_t>(number),
              amplitudes_, line.coefficients);
  if (!summits_) return;
  countStage(Stage::SummitCorrelation);
  line = withSummitCorrelation(line, surface_.summitCorrelation, *summits_);
}

Line LineSource::makeShape() const {
  switch (surface_.kind) {
    case SurfaceKind::Wedge:
      return wedgeLine(length_, nodes_, surface_.slope);
    case SurfaceKind::Parabola:
      return parabolaLine(length_, nodes_, surface_.radius);
    default:
      return sineLine(length_, nodes_, surface_.amplitude, surface_.waves);
  }
}

bool LineSource::setFromSpectrum(const FourierLine& modes, Slopes slopes, Line& line,
                                 const std::stop_token& stop) const {
  line.length = length_;
  line.spacing = length_ / static_cast<double>(nodes_);
  line.slopeAfter.clear();
  line.slopeBefore.clear();  // no corners; the line may have been another with some
  if (!transform_->evaluate(modes, line.height, stop)) return false;
  if (slopes == Slopes::Computed && !transform_->evaluateSlope(modes, line.slopeAfter, stop))
    return false;
  // The rms values are the same for every realization except with summit correlation, and of rows.
  const bool isKnown = isRandom() && !slopesDiffer() && statistics_.rmsHeight > 0;
  line.rmsHeight = isKnown ? statistics_.rmsHeight : rmsHeight(modes);
  line.rmsSlope = isKnown ? statistics_.rmsSlope : rmsSlope(modes);
  return true;
}

bool LineSource::makeInto(Line& line, std::int64_t number, Slopes slopes,
                          const std::stop_token& stop) const {
  if (!isRandom()) {
    line = only_;
    return true;
  }
  static thread_local FourierLine modes;  // fresh pages cost more than a transform
  spectrumInto(modes, number);
  return setFromSpectrum(modes, slopes, line, stop);
}

Line LineSource::make(std::int64_t number) const {
  Line line;
  makeInto(line, number);
  return line;
}

NoteSet lineNotes(const LineSource& source) {
  NoteSet notes;
  notes.add(Note::SlopeAbove, source.statistics().rmsSlope > kSmallSlope);
  const MeasuredLines* measured = source.measured();
  if (!measured) return notes;
  notes.add(Note::Spikes, measured->spikes() > 0);
  notes.add(Note::CoarseHeights, measured->coarseRows().coarse > 0);
  notes.add(Note::RoundForm, measured->radiusOfForm() > 0);
  if (!measured->mayHaveSeamJump()) return notes;
  // A few rows suffice, because most of them have such a step.
  constexpr std::int64_t kRows = 16;
  const std::int64_t count = std::min(measured->rows(), kRows);
  for (std::int64_t i = 0; i < count && !notes.has(Note::SeamJump); ++i)
    notes.add(Note::SeamJump, measured->hasSeamJump(
                                  measured->profile(rowOfRealization(i, count, measured->rows()))));
  return notes;
}

FourierLine modesOf(const LineSource& source) {
  FourierLine modes = source.spectrum(0);
  if (!modes.coefficients.empty()) return modes;
  const Line line = source.make(0);
  return FourierTransform(line.nodes()).analyse(line.height, line.length);
}

}  // namespace asperity
