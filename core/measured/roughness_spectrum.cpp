#include "core/measured/roughness_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/fourier.h"
#include "core/base/statistics.h"
#include "core/base/stop.h"
#include "core/measured/measured_file.h"
#include "core/measured/processing.h"

namespace asperity {
namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;

std::vector<double> hannWindow(std::size_t points) {
  std::vector<double> window(points);
  double square = 0;
  for (std::size_t i = 0; i < points; ++i) {
    window[i] =
        0.5 - 0.5 * std::cos(kTwoPi * (static_cast<double>(i) + 0.5) / static_cast<double>(points));
    square += window[i] * window[i];
  }
  const double factor = std::sqrt(static_cast<double>(points) / square);
  for (double& value : window) value *= factor;
  return window;
}

/// Spectra of profiles of one size.
class HannAnalysis {
 public:
  explicit HannAnalysis(std::size_t points)
      : window_(hannWindow(points)), windowed_(points), transform_(points) {}

  std::vector<double> powers(std::span<const double> heights) {
    const std::size_t points = heights.size();
    for (std::size_t i = 0; i < points; ++i) windowed_[i] = heights[i] * window_[i];
    const auto modes = transform_.forward(windowed_);
    std::vector<double> powers(modes.size());
    const double scale = 1 / (static_cast<double>(points) * static_cast<double>(points));
    for (std::size_t k = 0; k < modes.size(); ++k)
      powers[k] = (k == 0 || 2 * k == points ? 1 : 2) * std::norm(modes[k]) * scale;
    return powers;
  }

 private:
  std::vector<double> window_, windowed_;
  RealTransform transform_;
};

/// Returns whether a few of the waves first to end - 1 have nearly all of their power, as the
/// harmonics of a turned or milled surface have. In noise and random roughness all waves have
/// power: it is distributed exponentially over the waves, with a median of ln 2 times the mean.
bool hasPeaks(std::span<const double> powers, std::size_t first, std::size_t end) {
  constexpr std::size_t kFew = 8;
  constexpr double kMuch = 10;
  if (end - first < kFew) return false;
  const std::span<const double> waves = powers.subspan(first, end - first);
  return mean(waves) > kMuch * upperMedian({waves.begin(), waves.end()});
}

/// Reports the finished rows of long work, and ends it where a stop was requested.
class RowProgress {
 public:
  RowProgress(std::size_t rows, const std::stop_token& stop,
              const std::function<void(double)>& progress)
      : rows_(rows), stop_(stop), progress_(progress) {}

  void next() {
    throwIfStopped(stop_);
    constexpr std::size_t kReports = 64;  // times in all
    const std::size_t before = done_ * kReports / rows_, now = ++done_ * kReports / rows_;
    if (progress_ && now > before) progress_(static_cast<double>(now) / kReports);
  }

 private:
  std::size_t rows_, done_ = 0;
  const std::stop_token& stop_;
  const std::function<void(double)>& progress_;
};

}  // namespace

std::vector<double> hannPowers(std::span<const double> heights) {
  return HannAnalysis(heights.size()).powers(heights);
}

SpectralDensity hannSpectrum(std::span<const double> heights, double spacing) {
  const std::vector<double> powers = hannPowers(heights);
  const double lowest = kTwoPi / (static_cast<double>(heights.size()) * spacing);
  SpectralDensity density;
  density.waveNumber.reserve(powers.size());
  density.density.reserve(powers.size());
  for (std::size_t k = 1; k < powers.size(); ++k) {
    density.waveNumber.push_back(lowest * static_cast<double>(k));
    density.density.push_back(powers[k] / (2 * lowest));
  }
  return density;
}

// ---- Bands --------------------------------------------------------------------------------------

double BandPowers::from(std::size_t band) const {
  return kTwoPi / length * (static_cast<double>(first[band]) - 0.5);
}

double BandPowers::to(std::size_t band) const {
  return kTwoPi / length * (static_cast<double>(first[band + 1]) - 0.5);
}

double BandPowers::centre(std::size_t band) const {
  return std::sqrt(from(band) * to(band));
}

double BandPowers::total() const {
  return std::accumulate(power.begin(), power.end(), 0.0);
}

double BandPowers::rmsSlope() const {
  double sum = 0;
  for (std::size_t j = 0; j < bands(); ++j) {
    // This is the mean of q^2 over a band of constant power per octave.
    const double low = from(j), high = to(j);
    sum += power[j] * (high * high - low * low) / (2 * std::log(high / low));
  }
  return std::sqrt(sum);
}

SpectralDensity BandPowers::density() const {
  SpectralDensity density;
  for (std::size_t j = 0; j < bands(); ++j) {
    const double value = power[j] / (2 * (to(j) - from(j)));
    // The outermost bands extend to their edges.
    if (j == 0) {
      density.waveNumber.push_back(from(j));
      density.density.push_back(value);
    }
    density.waveNumber.push_back(centre(j));
    density.density.push_back(value);
    if (j + 1 == bands()) {
      density.waveNumber.push_back(to(j));
      density.density.push_back(value);
    }
  }
  // Between the centres of two bands the density is a power law, so a band of a steep spectrum gets
  // another power than it has. A few steps of correction return it.
  constexpr int kCorrections = 3;
  for (int step = 0; step < kCorrections; ++step) {
    std::vector<double> factor(bands(), 1.0);
    for (std::size_t j = 0; j < bands(); ++j) {
      const double its = 2 * (density.integralTo(to(j)) - density.integralTo(from(j)));
      if (its > 0) factor[j] = power[j] / its;
    }
    for (std::size_t i = 0; i < density.density.size(); ++i)
      density.density[i] *= factor[std::clamp<std::size_t>(i, 1, bands()) - 1];
  }
  const double whole = 2 * density.integral();
  if (whole > 0)
    for (double& value : density.density) value *= total() / whole;
  return density;
}

BandPowers inBands(std::span<const double> powers, double length) {
  constexpr double kToDecade = 8;
  const double ratio = std::pow(10.0, 1 / kToDecade);
  BandPowers bands{length, {1}, {}};
  for (std::size_t first = 1; first < powers.size();) {
    const auto wanted = static_cast<std::size_t>(std::floor(static_cast<double>(first) * ratio));
    const std::size_t end = std::min(std::max(wanted, first + 1), powers.size());
    bands.power.push_back(std::accumulate(powers.begin() + static_cast<std::ptrdiff_t>(first),
                                          powers.begin() + static_cast<std::ptrdiff_t>(end), 0.0));
    bands.first.push_back(end);
    first = end;
  }
  if (!bands.power.empty() && !powers.empty()) bands.power[0] += powers[0];
  return bands;
}

ReliableBand reliableBand(std::span<const double> heights, double spacing, double shortWaveCut,
                          const HeightSteps& steps) {
  const double length = static_cast<double>(heights.size()) * spacing;
  ReliableBand band{3 * kTwoPi / length, 0.5 * std::numbers::pi / spacing};
  if (shortWaveCut > 0) band.to = std::min(band.to, kTwoPi / shortWaveCut);
  const std::vector<double> powers = hannPowers(heights);
  const BandPowers bands = inBands(powers, length);
  // From the top down, this finds the lowest band from which on the density falls more slowly than
  // 1/q. The slope is taken over half a decade, because single bands scatter.
  constexpr std::size_t kStride = 6;
  const auto densityAt = [&](std::size_t j) {
    return bands.power[j] / (bands.to(j) - bands.from(j));
  };
  for (std::size_t j = bands.bands(); j-- > kStride;) {
    const double low = densityAt(j - kStride), high = densityAt(j);
    const double exponent =
        low > 0 && high > 0
            ? std::log(high / low) / std::log(bands.centre(j) / bands.centre(j - kStride))
            : -2;
    if (exponent < -1 || hasPeaks(powers, bands.first[j - kStride], bands.first[j + 1])) break;
    if (bands.from(j - kStride) < band.to) {
      band.to = bands.from(j - kStride);
      band.endsInNoise = true;
    }
  }
  // The error of rounding has the variance step^2 / 12. A stair has fewer independent errors than
  // points, as many as it has steps.
  const double stepsPerPoint =
      steps.step > 0 ? std::min(1.0, std::pow(steps.spread / steps.step, 2)) : 1;
  const double rounding = steps.step * steps.step / 12 * spacing / std::numbers::pi / stepsPerPoint;
  constexpr double kClear = 4;
  for (std::size_t j = bands.bands(); j-- > 0 && densityAt(j) < kClear * rounding;)
    if (bands.from(j) < band.to) {
      band.to = bands.from(j);
      band.endsInNoise = true;
    }
  // A spectrum does not fall at all where the line is smooth with white noise, or short.
  if (band.to <= band.from) band.to = band.from;
  return band;
}

// ---- The equivalent line -----------------------------------------------------------------------

double EquivalentSpectra::factor(double q) const {
  const std::size_t bands = profile.bands();
  if (bands == 0) return 1;
  std::size_t band = 0;
  while (band + 1 < bands && profile.to(band) <= q) ++band;
  return profile.power[band] > 0 ? std::sqrt(line.power[band] / profile.power[band]) : 1;
}

namespace {

/// Returns the part of the power of ring `ring` that appears in each band up to it in a cut: phi is
/// uniform, and the power of the ring is equal in each octave.
std::vector<double> ringShares(const BandPowers& bands, std::size_t ring) {
  constexpr int kRadii = 16;
  std::vector<double> shares(ring + 1);
  const double low = bands.from(ring), high = bands.to(ring);
  for (int r = 0; r < kRadii; ++r) {
    const double radius = low * std::pow(high / low, (r + 0.5) / kRadii);
    double below = 0;  // part at lower wave numbers
    for (std::size_t j = 0; j <= ring; ++j) {
      const double upTo = 2 / std::numbers::pi * std::asin(std::min(bands.to(j) / radius, 1.0));
      shares[j] += (upTo - below) / kRadii;
      below = upTo;
    }
  }
  return shares;
}

/// Improves powers of which `seen` is a picture, by one step of expectation and maximisation (Lucy
/// 1974; Richardson 1972). shares: of each power, the part that is seen in each band.
void improve(std::vector<double>& powers, std::span<const double> seen,
             const std::vector<std::vector<double>>& shares) {
  std::vector<double> expected(seen.size());
  for (std::size_t i = 0; i < powers.size(); ++i)
    for (std::size_t j = 0; j < shares[i].size(); ++j) expected[j] += shares[i][j] * powers[i];
  for (std::size_t i = 0; i < powers.size(); ++i) {
    double factor = 0, whole = 0;
    for (std::size_t j = 0; j < shares[i].size(); ++j) {
      if (expected[j] > 0) factor += shares[i][j] * (seen[j] / expected[j]);
      whole += shares[i][j];
    }
    if (whole > 0) powers[i] *= factor / whole;
  }
}

/// Multiplies all powers by a power law of q so that their sum and their rms slope have the given
/// values.
void tilt(BandPowers& bands, double total, double rmsSlope) {
  constexpr double kSteepest = 4;
  constexpr int kHalvings = 60;
  if (!(total > 0)) return;
  const auto tilted = [&](double exponent) {
    BandPowers some = bands;
    for (std::size_t j = 0; j < some.bands(); ++j)
      some.power[j] *= std::pow(some.centre(j) / some.centre(0), exponent);
    const double factor = total / some.total();
    for (double& power : some.power) power *= factor;
    return some;
  };
  double low = -kSteepest, high = kSteepest;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (tilted(middle).rmsSlope() < rmsSlope ? low : high) = middle;
  }
  bands = tilted(0.5 * (low + high));
}

}  // namespace

EquivalentSpectra equivalentSpectra(const BandPowers& profile) {
  constexpr int kRounds = 100;
  EquivalentSpectra spectra{profile, profile};
  std::vector<std::vector<double>> shares;
  for (std::size_t ring = 0; ring < profile.bands(); ++ring)
    shares.push_back(ringShares(profile, ring));
  for (int round = 0; round < kRounds; ++round) improve(spectra.line.power, profile.power, shares);
  tilt(spectra.line, profile.total(), std::numbers::sqrt2 * profile.rmsSlope());
  return spectra;
}

namespace {

/// Which modes of a two-dimensional spectrum belong to which ring. Each ring is as wide as one wave
/// along x. Where the other direction is sampled more coarsely, rings are incomplete, and the
/// available part represents the whole.
class Rings {
 public:
  explicit Rings(const Topography& topography)
      : rows_(static_cast<std::size_t>(topography.rows)),
        columns_(static_cast<std::size_t>(topography.columns)),
        waves_(topography.length() / topography.width()),
        scale_(columns_ / 2 + 1) {
    std::vector<double> count(scale_.size());
    for (std::size_t row = 0; row < rows_; ++row)
      for (std::size_t k = 0; k < scale_.size(); ++k)
        if (const std::size_t ring = number(static_cast<double>(k), waveAcross(row));
            ring < scale_.size())
          count[ring] += times(k);
    const double highestAcross = 0.5 * static_cast<double>(rows_) * waves_;
    for (std::size_t k = 0; k < scale_.size(); ++k) {
      const double whole = kTwoPi * static_cast<double>(k) / waves_;
      const bool isIncomplete = static_cast<double>(k) + 0.5 > highestAcross && count[k] > 0;
      scale_[k] = isIncomplete && k > 0 ? whole / count[k] : 1;
    }
  }

  std::size_t size() const { return scale_.size(); }
  /// Returns the number of the ring, which may lie beyond the last one. Unit: one wave along x.
  static std::size_t number(double along, double across) {
    return static_cast<std::size_t>(std::sqrt(along * along + across * across) + 0.5);
  }
  double waveAcross(std::size_t row) const {
    return static_cast<double>(std::min(row, rows_ - row)) * waves_;
  }
  /// Returns how many modes of the whole spectrum column k of its half stands for.
  double times(std::size_t k) const { return k == 0 || 2 * k == columns_ ? 1 : 2; }
  /// Returns the factor that completes a ring.
  double scale(std::size_t ring) const { return scale_[ring]; }

 private:
  std::size_t rows_, columns_;
  double waves_;
  std::vector<double> scale_;
};

/// Returns the part of the power of each band of an isotropic surface that the rings show in each
/// band under the window across the rows. The window spreads each wave over its neighbours: over
/// the next two by its main lobe, which is wide where the rows are few, and over all by its side
/// lobes, which matter where the spectrum is steep.
std::vector<std::vector<double>> sharesUnderWindow(const BandPowers& bands, const Rings& rings,
                                                   std::size_t rows) {
  constexpr long kParts = 16;  // of the distance between two waves across
  constexpr long kReach = 64;  // waves; beyond it are 1e-12 of the power
  constexpr int kRadii = 16, kAngles = 64;
  // Padded by zeros, the spectrum of the window is known between the waves across as well.
  std::vector<double> window = hannWindow(rows);
  window.resize(static_cast<std::size_t>(kParts) * rows);
  std::vector<double> spread;
  for (const std::complex<double>& mode : RealTransform(window.size()).forward(window))
    spread.push_back(std::norm(mode) / static_cast<double>(rows * rows * kRadii * kAngles));
  std::vector<std::size_t> bandOfRing(rings.size());
  for (std::size_t band = 0; band < bands.bands(); ++band)
    for (std::size_t ring = bands.first[band]; ring < bands.first[band + 1]; ++ring)
      bandOfRing[ring] = band;
  const auto period = static_cast<long>(window.size()), count = static_cast<long>(rows);
  const double unit = kTwoPi / bands.length;
  std::vector<std::vector<double>> shares(bands.bands(), std::vector<double>(bands.bands()));
  for (std::size_t band = 0; band < bands.bands(); ++band) {
    const double low = bands.from(band) / unit, high = bands.to(band) / unit;
    for (int sample = 0; sample < kRadii * kAngles; ++sample) {
      const double radius = low * std::pow(high / low, (sample / kAngles + 0.5) / kRadii);
      const double angle = 0.5 * std::numbers::pi * (sample % kAngles + 0.5) / kAngles;
      const double along = radius * std::cos(angle), across = radius * std::sin(angle);
      const long place = std::lround(across / rings.waveAcross(1) * kParts);
      const long nearest = place / kParts;
      const long first = nearest - std::min(kReach, count / 2);
      const long end = std::min(nearest + kReach + 1, first + count);
      // Waves across beyond the highest one appear as lower ones.
      auto row = static_cast<std::size_t>((first % count + count) % count);
      for (long wave = first; wave < end; ++wave, row = row + 1 == rows ? 0 : row + 1) {
        const long apart = std::abs(wave * kParts - place);
        const std::size_t ring = Rings::number(along, rings.waveAcross(row));
        if (ring < rings.size())
          shares[band][bandOfRing[ring]] +=
              rings.scale(ring) * spread[static_cast<std::size_t>(std::min(apart, period - apart))];
      }
    }
  }
  return shares;
}

}  // namespace

EquivalentSpectra equivalentSpectra(const Topography& topography, FormRemoval form,
                                    const std::stop_token& stop,
                                    const std::function<void(double)>& progress) {
  const auto rows = static_cast<std::size_t>(topography.rows);
  const auto columns = static_cast<std::size_t>(topography.columns);
  // The work passes over all rows three times.
  RowProgress done(3 * rows, stop, progress);
  std::vector<double> heights = topography.height;
  removeForm(heights, rows, columns, form);
  std::vector<double> profile(columns / 2 + 1);
  HannAnalysis analysis(columns);
  for (std::size_t row = 0; row < rows; ++row) {
    done.next();
    const std::vector<double> powers =
        analysis.powers(std::span(heights).subspan(row * columns, columns));
    for (std::size_t k = 0; k < powers.size(); ++k)
      profile[k] += powers[k] / static_cast<double>(rows);
  }
  const std::vector<double> alongX = hannWindow(columns), alongY = hannWindow(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    done.next();
    for (std::size_t column = 0; column < columns; ++column)
      heights[row * columns + column] *= alongX[column] * alongY[row];
  }
  const auto modes = transform2d(heights, rows, columns);
  heights = {};
  const Rings rings(topography);
  std::vector<double> ring(rings.size());
  const double points = static_cast<double>(rows) * static_cast<double>(columns);
  for (std::size_t row = 0; row < rows; ++row) {
    done.next();
    for (std::size_t k = 0; k < columns / 2 + 1; ++k) {
      const std::size_t number = Rings::number(static_cast<double>(k), rings.waveAcross(row));
      if (number >= ring.size()) continue;
      ring[number] += rings.scale(number) * rings.times(k) *
                      std::norm(modes[row * (columns / 2 + 1) + k]) / (points * points);
    }
  }
  const double length = topography.length();
  // The rows alone determine the spectrum of an isotropic surface. What the rings show beyond what
  // they would show of that surface makes the difference of another one.
  EquivalentSpectra spectra = equivalentSpectra(inBands(profile, length));
  improve(spectra.line.power, inBands(ring, length).power,
          sharesUnderWindow(spectra.line, rings, rows));
  return spectra;
}

}  // namespace asperity
