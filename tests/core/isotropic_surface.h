// A synthetic isotropic surface with random phases, made by FFTW directly so that tests do not
// share the transforms and spectra of the program: C2(q) ~ (q^2 + q_r^2)^(-1-H) up to a highest
// wave number, periodic on a square of which a part is handed out, so that the part is not
// periodic.
#pragma once

#include <fftw3.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "core/measured/topography.h"

namespace asperity {

struct IsotropicSurface {
  std::size_t size = 512;  // points of the periodic square's side
  std::size_t part = 256;  // of what is handed out
  double spacing = 1e-6;   // m
  double hurst = 0.7;
  double rollOffWaves = 24;  // of the square: waves in it at the roll-off
  double highestWaves = 128;
  double height = 1e-6;  // m, rms

  double weight(double k) const {
    return k > highestWaves || k == 0 ? 0
                                      : std::pow(k * k + rollOffWaves * rollOffWaves, -1 - hurst);
  }
  double lowest() const { return 2 * std::numbers::pi / (static_cast<double>(size) * spacing); }

  /// Mean square of the heights over that of the weights, summed over the lattice.
  template <class Factor>
  double sum(const Factor& factor) const {
    double all = 0;
    const auto half = static_cast<int>(size / 2);
    for (int ky = -half; ky < half; ++ky)
      for (int kx = -half; kx < half; ++kx) {
        const double k = std::sqrt(kx * kx + ky * ky);
        all += weight(k) * factor(k);
      }
    return all;
  }
  /// <|grad h|^2> of the whole.
  double squareGradient() const {
    const double q = lowest();
    return height * height * sum([q](double k) { return q * q * k * k; }) /
           sum([](double) { return 1.0; });
  }

  /// Factors of the modes of white noise, which take most of the time: several surfaces share them.
  std::vector<double> amplitudes() const {
    const std::size_t half = size / 2 + 1;
    const double scale =
        height / std::sqrt(sum([](double) { return 1.0; })) / static_cast<double>(size);
    std::vector<double> amplitudes(size * half);
    for (std::size_t y = 0; y < size; ++y)
      for (std::size_t x = 0; x < half; ++x) {
        const double ky = static_cast<double>(y <= size / 2 ? y : size - y);
        amplitudes[y * half + x] =
            scale * std::sqrt(weight(std::hypot(static_cast<double>(x), ky)));
      }
    return amplitudes;
  }

  Topography make(unsigned seed) const { return make(seed, amplitudes()); }

  Topography make(unsigned seed, const std::vector<double>& amplitudes) const {
    std::mt19937_64 random(seed);
    const std::size_t half = size / 2 + 1;
    auto* modes =
        reinterpret_cast<std::complex<double>*>(fftw_malloc(sizeof(fftw_complex) * size * half));
    auto* heights = static_cast<double*>(fftw_malloc(sizeof(double) * size * size));
    // White noise has the symmetry of real numbers; its modes are weighted. Each of them is the sum
    // of so many numbers of variance 1 that these need not be normally distributed.
    for (std::size_t i = 0; i < size * size; ++i)
      heights[i] = std::sqrt(12.0) * (std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5);
    const int n = static_cast<int>(size);
    auto* raw = reinterpret_cast<fftw_complex*>(modes);
    fftw_plan plan = fftw_plan_dft_r2c_2d(n, n, heights, raw, FFTW_ESTIMATE);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    for (std::size_t i = 0; i < size * half; ++i) modes[i] *= amplitudes[i];
    plan = fftw_plan_dft_c2r_2d(n, n, raw, heights, FFTW_ESTIMATE);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    Topography topography;
    topography.columns = topography.rows = static_cast<std::int64_t>(part);
    topography.columnSpacing = topography.rowSpacing = spacing;
    for (std::size_t y = 0; y < part; ++y)
      for (std::size_t x = 0; x < part; ++x) topography.height.push_back(heights[y * size + x]);
    fftw_free(modes);
    fftw_free(heights);
    return topography;
  }
};

}  // namespace asperity
