#include "core/surface/line_source.h"

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/scene/parameters.h"
#include "core/scene/plan.h"
#include "core/surface/profile_file.h"
#include "core/surface/random_phases.h"
#include "core/surface/spectrum.h"

namespace asperity {
namespace {

constexpr std::int64_t kMostNodes = std::int64_t{1} << 26;
constexpr std::int64_t kNodesOfProduct = 4;  // per element, of a product of waves: not aliased

/// What `read` makes of the scene's file; errors name the key that names the file.
template <class Read>
auto readFile(const Scene& scene, const Read& read) {
  try {
    return read(scene.folder / scene.surface.file);
  } catch (const InputError& error) {
    throw InputError("", "surface.file", messageOf(error));
  }
}

/// The length (m) of a profile: the scene's, or that of the file's positions.
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

}  // namespace

LineExtent lineExtent(const Scene& scene) {
  const Surface& surface = scene.surface;
  if (surface.kind != SurfaceKind::Profile)
    return {surface.length, surface.elements, 0, surface.rmsHeight};
  const ProfileExtent file = readFile(scene, profileExtent);
  return {profileLength(surface, file.length), surface.elements > 0 ? surface.elements : file.rows,
          file.rows, file.rmsHeight};
}

Profile readProfileStart(const Scene& scene, std::int64_t rows) {
  return readFile(scene, [rows](const auto& file) { return readProfileStart(file, rows); });
}

LineSource::LineSource(const Scene& scene, std::int64_t oversampling, const Profile* profile)
    : surface_(scene.surface), length_(surface_.length), elements_(surface_.elements) {
  if (surface_.kind == SurfaceKind::Profile)
    setProfile(profile ? *profile : readFile(scene, readProfile));
  if (elements_ * oversampling > kMostNodes)
    throw InputError("", "surface.elements",
                     message("{} times oversampling {} is more than {} points", elements_,
                             oversampling, kMostNodes));
  nodes_ = static_cast<std::size_t>(elements_ * oversampling);
  if (surface_.kind == SurfaceKind::Sine && surface_.waves > (elements_ - 1) / 2)
    throw InputError("", "surface.waves",
                     message("{} is outside 1 to {}, what {} elements carry", surface_.waves,
                             (elements_ - 1) / 2, elements_));
  if (surface_.kind == SurfaceKind::SelfAffine) setAmplitudes(scene);
  if (surface_.kind == SurfaceKind::SelfAffine || surface_.kind == SurfaceKind::Profile)
    transform_.emplace(nodes_);
  if (isRandom()) {
    const FourierLine modes = spectrum(0);
    statistics_ = {rmsHeight(modes), rmsSlope(modes)};
  } else {
    if (transform_)
      setFromSpectrum(profile_, Slopes::Wanted, only_, {});
    else
      only_ = makeShape();
    statistics_ = {only_.rmsHeight, only_.rmsSlope};
  }
}

/// Half of each cosine's amplitude: the coefficient of exp(i q x).
void LineSource::setAmplitudes(const Scene& scene) {
  const bool rollsOff = callsFor(scene, Purpose::Surface, Stage::RollOff);
  if (rollsOff) countStage(Stage::RollOff);
  amplitudes_ =
      selfAffineAmplitudes(static_cast<std::size_t>(elements_), surface_.hurst, surface_.rmsHeight,
                           rollsOff ? length_ / surface_.rollOffWavelength : 0);
  if (callsFor(scene, Purpose::Surface, Stage::SummitCorrelation))
    summits_.emplace(static_cast<std::size_t>(elements_ * kNodesOfProduct));
  for (double& amplitude : amplitudes_) amplitude /= 2;
}

void LineSource::setProfile(const Profile& profile) {
  length_ = profileLength(surface_, profile.length);
  if (elements_ == 0) elements_ = static_cast<std::int64_t>(profile.height.size());
  profile_ = FourierTransform(profile.height.size()).analyse(profile.height, length_);
  const std::size_t most = modeCount(static_cast<std::size_t>(elements_));
  if (profile_.coefficients.size() > most) profile_.coefficients.resize(most);
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
  if (slopes == Slopes::Wanted && !transform_->evaluateSlope(modes, line.slopeAfter, stop))
    return false;
  // The rms values are the same for every realization except with summit correlation.
  const bool isKnown = isRandom() && !summits_ && statistics_.rmsHeight > 0;
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

}  // namespace asperity
