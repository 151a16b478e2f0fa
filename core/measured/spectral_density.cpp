#include "core/measured/spectral_density.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/statistics.h"

namespace asperity {
namespace {

/// The part of a density between two points or in one bin: a power law where both values are above
/// 0, else a straight line.
struct Piece {
  double from, fromValue, to, toValue;

  /// Returns the integral from the beginning to x.
  double integralTo(double x) const {
    constexpr double kNear = 1e-9;  // relative distance below which no power law is used
    if (!(fromValue > 0) || !(toValue > 0) || to - from < kNear * from) {
      const double value = fromValue + (toValue - fromValue) * (x - from) / (to - from);
      return 0.5 * (fromValue + value) * (x - from);
    }
    const double exponent = std::log(toValue / fromValue) / std::log(to / from) + 1;
    const double ratio = std::log(x / from);
    // (e^(a r) - 1) / a tends to r for small a.
    return fromValue * from *
           (std::abs(exponent * ratio) < 1e-12 ? ratio : std::expm1(exponent * ratio) / exponent);
  }
};

std::size_t pieces(const SpectralDensity& density) {
  return std::max<std::size_t>(std::max(density.waveNumber.size(), density.binEdge.size()), 1) - 1;
}

Piece piece(const SpectralDensity& density, std::size_t i) {
  const auto& [wave, value, edge] = density;
  if (!edge.empty()) return {edge[i], value[i], edge[i + 1], value[i]};
  return {wave[i], value[i], wave[i + 1], value[i + 1]};
}

SpectralDensity binsWithin(const SpectralDensity& density, double lowest, double highest) {
  SpectralDensity part;
  for (std::size_t i = 0; i < density.density.size(); ++i) {
    const double from = std::max(density.binEdge[i], lowest);
    const double to = std::min(density.binEdge[i + 1], highest);
    if (!(from < to)) continue;
    part.waveNumber.push_back(std::clamp(density.waveNumber[i], from, to));
    part.density.push_back(density.density[i]);
    if (part.binEdge.empty()) part.binEdge.push_back(from);
    part.binEdge.push_back(to);
  }
  return part;
}

}  // namespace

double SpectralDensity::integralTo(double q) const {
  double sum = 0;
  for (std::size_t i = 0; i < pieces(*this); ++i) {
    const Piece one = piece(*this, i);
    if (one.from >= q) break;
    sum += one.integralTo(std::min(q, one.to));
  }
  return sum;
}

double SpectralDensity::integral() const {
  return integralTo(std::numeric_limits<double>::infinity());
}

std::vector<double> findBinEdges(std::span<const double> waveNumbers) {
  constexpr std::size_t kMin = 4;
  constexpr double kOfStep = 0.25, kOfMultiple = 0.05;
  const std::size_t count = waveNumbers.size();
  if (count < kMin) return {};
  std::vector<double> spacings;
  for (std::size_t i = 1; i < count; ++i) spacings.push_back(waveNumbers[i] - waveNumbers[i - 1]);
  const double middle = upperMedian(spacings);
  double step = 0, steps = 0;
  for (const double spacing : spacings)
    if (std::abs(spacing - middle) <= kOfStep * middle) {
      step += spacing;
      ++steps;
    }
  step /= steps;
  const double multiple = waveNumbers.front() / step;
  if (10 * steps < 9 * static_cast<double>(spacings.size()) || !(multiple > 1 - kOfMultiple) ||
      std::abs(multiple - std::round(multiple)) > kOfMultiple)
    return {};
  std::vector<double> edges{waveNumbers.front() - 0.5 * step};
  for (std::size_t i = 1; i < count; ++i)
    edges.push_back(0.5 * (waveNumbers[i - 1] + waveNumbers[i]));
  edges.push_back(waveNumbers.back() + 0.5 * step);
  return edges;
}

SpectralDensity within(const SpectralDensity& density, double lowest, double highest) {
  if (!density.binEdge.empty()) return binsWithin(density, lowest, highest);
  const std::vector<double>& q = density.waveNumber;
  SpectralDensity part;
  const auto add = [&part](double wave, double value) {
    part.waveNumber.push_back(wave);
    part.density.push_back(value);
  };
  // Returns the density at a wave number inside a segment.
  const auto between = [&](std::size_t i, double wave) {
    const double low = density.density[i], high = density.density[i + 1];
    if (!(low > 0) || !(high > 0)) return low + (high - low) * (wave - q[i]) / (q[i + 1] - q[i]);
    return low * std::pow(high / low, std::log(wave / q[i]) / std::log(q[i + 1] / q[i]));
  };
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (i > 0 && q[i - 1] < lowest && lowest < q[i]) add(lowest, between(i - 1, lowest));
    if (q[i] >= lowest && q[i] <= highest) add(q[i], density.density[i]);
    if (i + 1 < q.size() && q[i] < highest && highest < q[i + 1] && highest > lowest)
      add(highest, between(i, highest));
  }
  return part;
}

std::vector<double> modeMagnitudes(const SpectralDensity& density, double length,
                                   std::size_t modes) {
  std::vector<double> magnitudes(modes);
  const std::size_t count = pieces(density);
  if (count == 0) return magnitudes;
  const double lowest = 2 * std::numbers::pi / length;
  // Both the edges of the modes and the pieces of the density ascend, so one pass visits both.
  std::size_t i = 0;
  double before = 0;  // integral up to the piece
  const auto integralTo = [&](double edge) {
    Piece one = piece(density, i);
    for (; i + 1 < count && one.to < edge; one = piece(density, ++i))
      before += one.integralTo(one.to);
    return before + one.integralTo(std::clamp(edge, one.from, one.to));
  };
  double last = integralTo(0.5 * lowest);
  for (std::size_t k = 1; k <= modes; ++k) {
    const double next = integralTo((static_cast<double>(k) + 0.5) * lowest);
    magnitudes[k - 1] = std::sqrt(std::max(next - last, 0.0));
    last = next;
  }
  return magnitudes;
}

}  // namespace asperity
