#include "core/surface/summit_correlation.h"

#include <algorithm>
#include <cmath>

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
