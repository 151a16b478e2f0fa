#include "core/surface/spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/surface/fourier.h"

namespace asperity {
namespace {

constexpr double kLargest = 0.99;  // of |kappa m|

/// The modes from `first` up to below `end`, counted from 1; the others are 0.
FourierLine partOf(const FourierLine& line, std::size_t first, std::size_t end) {
  FourierLine part{line.length, std::vector<std::complex<double>>(line.coefficients.size())};
  for (std::size_t k = first; k < end; ++k) part.coefficients[k - 1] = line.coefficients[k - 1];
  return part;
}

}  // namespace

std::size_t modesOf(std::size_t elements) {
  return (elements - 1) / 2;
}

std::vector<double> selfAffineAmplitudes(std::size_t elements, double hurst, double rmsHeight,
                                         double rollOff) {
  std::vector<double> amplitudes(modesOf(elements));
  double sum = 0;
  for (std::size_t j = amplitudes.size(); j-- > 0;) {  // small terms first
    const double density = std::pow(std::max(static_cast<double>(j + 1), rollOff), -2 * hurst - 1);
    amplitudes[j] = std::sqrt(density);
    sum += density;
  }
  const double factor = rmsHeight * std::sqrt(2 / sum);
  for (double& amplitude : amplitudes) amplitude *= factor;
  return amplitudes;
}

double rmsHeightOf(const FourierLine& line) {
  double sum = 0;
  for (std::size_t j = line.coefficients.size(); j-- > 0;) sum += std::norm(line.coefficients[j]);
  return std::sqrt(2 * sum);
}

double rmsSlopeOf(const FourierLine& line) {
  double sum = 0;
  for (std::size_t j = line.coefficients.size(); j-- > 0;) {
    const double mode = static_cast<double>(j + 1);
    sum += std::norm(line.coefficients[j]) * mode * mode;
  }
  return 2 * std::numbers::pi / line.length * std::sqrt(2 * sum);
}

FourierLine withSummitCorrelation(const FourierLine& line, double kappa,
                                  const FourierTransform& fine) {
  const std::size_t modes = line.coefficients.size();
  const auto split = static_cast<std::size_t>(std::sqrt(static_cast<double>(modes)));
  const FourierLine longWaves = partOf(line, 1, split + 1);
  const double height = rmsHeightOf(line), longHeight = rmsHeightOf(longWaves);
  if (!(longHeight > 0) || modes < 2) return line;
  std::vector<double> far, near;
  fine.evaluate(longWaves, far);
  fine.evaluate(partOf(line, split + 1, modes + 1), near);
  for (std::size_t i = 0; i < far.size(); ++i)
    far[i] +=
        near[i] * std::sqrt(1 + std::clamp(-kappa * far[i] / longHeight, -kLargest, kLargest));
  FourierLine whole = fine.analyse(far, line.length);
  whole.coefficients.resize(modes);
  const double factor = height / rmsHeightOf(whole);
  for (std::complex<double>& coefficient : whole.coefficients) coefficient *= factor;
  return whole;
}

}  // namespace asperity
