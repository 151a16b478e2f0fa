#include "core/friction/excitation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/intervals.h"
#include "core/base/statistics.h"
#include "core/material/temperature_shift.h"
#include "core/surface/line_source.h"
#include "core/surface/spectrum.h"

namespace asperity {
namespace {

constexpr double kBandsPerDecade = 32;

double excitedFrequency(double waveNumber, double velocity) {
  return waveNumber * velocity / (2 * std::numbers::pi);
}

/// Returns whether the elastomer is at a temperature outside of the measured range.
bool isOutsideMeasuredTemperatures(const Elastomer& elastomer) {
  const MeasuredRange& range = elastomer.measured;
  if (elastomer.rheology != Rheology::Prony || !(range.temperatureTo > 0)) return false;
  // Isotherms are a few tenths of a kelvin off what was set.
  constexpr double kNear = 0.5;  // K
  return elastomer.temperature < range.temperatureFrom - kNear ||
         elastomer.temperature > range.temperatureTo + kNear;
}

}  // namespace

std::optional<FrequencyRange> measuredFrequencies(const Elastomer& elastomer) {
  const MeasuredRange& range = elastomer.measured;
  if (elastomer.rheology != Rheology::Prony || !(range.frequencyTo > 0)) return {};
  const double shift = shiftFactor(elastomer.shift, elastomer.temperature);
  return FrequencyRange{range.frequencyFrom / shift, range.frequencyTo / shift};
}

bool isExtrapolated(double shareNotMeasured) {
  return !std::isnan(shareNotMeasured) && shareNotMeasured > kMaxNotMeasured;
}

NoteSet elastomerNotes(const Elastomer& elastomer, double rmsSlope, double shareNotMeasured) {
  NoteSet notes;
  notes.add(Note::ExtrapolatedMaterial, isExtrapolated(shareNotMeasured));
  notes.add(Note::ExtrapolatedTemperature, isOutsideMeasuredTemperatures(elastomer));
  const double strain = elastomer.measured.strainAmplitude;
  notes.add(Note::StrainBeyondMeasured,
            elastomer.rheology == Rheology::Prony && strain > 0 && rmsSlope > strain);
  return notes;
}

ExcitedWaves excitedWaves(const LineSource& source) {
  const FourierLine modes = modesOf(source);
  const double lowest = 2 * std::numbers::pi / modes.length;
  std::vector<double> numbers, strengths;  // of the modes that the line has
  for (std::size_t j = 0; j < modes.coefficients.size(); ++j) {
    const auto number = static_cast<double>(j + 1);
    const double strength = lowest * number * std::norm(modes.coefficients[j]);
    if (!(strength > 0)) continue;
    numbers.push_back(number);
    strengths.push_back(strength);
  }
  std::vector<WaveBand> bands;
  for (const IndexRange& range : logBands(numbers, kBandsPerDecade)) {
    // Logarithms of wave numbers are averaged by strength.
    double sum = 0, logWave = 0;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      sum += strengths[i];
      logWave += strengths[i] * std::log(lowest * numbers[i]);
    }
    const double wave = std::exp(logWave / sum);
    // A single mode of the long waves covers the distance to its neighbours.
    const double decades = static_cast<double>(range.size()) * lowest / wave / std::numbers::ln10;
    bands.push_back({wave, sum, decades});
  }
  return std::make_shared<const std::vector<WaveBand>>(std::move(bands));
}

Excitation::Excitation(const Scene& scene, const LineSource& source)
    : Excitation(scene.elastomer, excitedWaves(source)) {}

Excitation::Excitation(const Elastomer& elastomer, ExcitedWaves waves)
    : waves_(std::move(waves)),
      law_(elementLaw(elastomer)),
      measured_(measuredFrequencies(elastomer)) {}

std::optional<ExcitedBand> Excitation::band(double velocity) const {
  double total = 0;
  std::vector<double> sums;
  for (const WaveBand& band : *waves_) {
    total += band.strength * complexModulus(law_, band.waveNumber * velocity).loss;
    sums.push_back(total);
  }
  if (!(total > 0) || !std::isfinite(total)) return {};
  const auto at = [&](double share) {
    const auto found = std::ranges::lower_bound(sums, share * total);
    const auto i = std::min<std::ptrdiff_t>(found - sums.begin(), std::ssize(sums) - 1);
    return excitedFrequency((*waves_)[static_cast<std::size_t>(i)].waveNumber, velocity);
  };
  return ExcitedBand{at(0.05), at(0.5), at(0.95)};
}

double Excitation::shareNotMeasured(double velocity) const {
  if (!measured_) return kNaN;
  double total = 0, outside = 0;
  for (const WaveBand& band : *waves_) {
    const double weight = band.strength * complexModulus(law_, band.waveNumber * velocity).loss;
    const double frequency = excitedFrequency(band.waveNumber, velocity);
    total += weight;
    if (frequency < measured_->from || frequency > measured_->to) outside += weight;
  }
  return total > 0 && std::isfinite(total) ? outside / total : kNaN;
}

std::vector<Excitation::Weight> Excitation::weights(double velocity) const {
  std::vector<Weight> weights;
  double largest = 0;
  for (const WaveBand& band : *waves_) {
    const double loss = complexModulus(law_, band.waveNumber * velocity).loss;
    weights.push_back(
        {excitedFrequency(band.waveNumber, velocity), band.strength * loss / band.decades});
    largest = std::max(largest, weights.back().weight);
  }
  if (!(largest > 0)) return {};
  for (Weight& weight : weights) weight.weight /= largest;
  return weights;
}

Excitation computeExcitation(const Scene& scene) {
  return {scene, LineSource(scene, 1)};
}

}  // namespace asperity
