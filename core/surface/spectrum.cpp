#include "core/surface/spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

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

}  // namespace asperity
