// A rubber whose moduli are known everywhere, and sweeps over it as an instrument would measure
// them. Written for tests alone: the sums are those of Ferry, ch. 3, and share nothing with the
// program.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/material/isotherms.h"

namespace asperity {

struct SyntheticRubber {
  double equilibrium = 1e6;  // Pa
  int arms = 15;

  /// At the reference temperature.
  DynamicModulus at(double frequency) const {
    DynamicModulus modulus{frequency, equilibrium, 0};
    for (int i = 0; i < arms; ++i) {
      const double tau = std::pow(10, -7 + 0.7 * i), g = 2e5 * std::pow(10, 1.8 * (1 - i / 14.0));
      const double turn = 2 * std::numbers::pi * frequency * tau;
      modulus.storage += g * turn * turn / (1 + turn * turn);
      modulus.loss += g * turn / (1 + turn * turn);
    }
    return modulus;
  }

  static constexpr double kReference = 298.15;  // K
  /// Williams, Landel and Ferry with C1 = 8.86 and C2 = 101.6 K.
  static double log10Shift(double kelvin) {
    const double above = kelvin - kReference;
    return -8.86 * above / (101.6 + above);
  }

  /// What is measured at a temperature: a number of points in [from, to] Hz, with relative noise.
  Isotherm sweep(double kelvin, double from, double to, int points, double noise = 0,
                 unsigned seed = 1) const {
    std::mt19937 random(seed * 1000 + static_cast<unsigned>(kelvin));
    std::normal_distribution<double> normal;
    Isotherm isotherm;
    isotherm.temperature = kelvin;
    const double shift = std::pow(10, log10Shift(kelvin));
    for (int i = 0; i < points; ++i) {
      const double frequency = from * std::pow(to / from, i / (points - 1.0));
      DynamicModulus modulus = at(frequency * shift);
      modulus.frequency = frequency;
      modulus.storage *= 1 + noise * normal(random);
      modulus.loss *= 1 + noise * normal(random);
      isotherm.points.push_back(modulus);
    }
    return isotherm;
  }

  /// From -5 to 55 °C in steps of 10 K; the fourth is the reference.
  std::vector<Isotherm> sweeps(int points, double noise = 0, unsigned seed = 1) const {
    std::vector<Isotherm> all;
    for (int i = 0; i < 7; ++i) all.push_back(sweep(268.15 + 10 * i, 0.1, 10, points, noise, seed));
    return all;
  }
};

/// Multiplies the moduli by b_T = T / T_0, as entropy elasticity does.
inline void makeEntropic(std::vector<Isotherm>& isotherms) {
  for (Isotherm& isotherm : isotherms)
    for (DynamicModulus& point : isotherm.points) {
      point.storage *= isotherm.temperature / SyntheticRubber::kReference;
      point.loss *= isotherm.temperature / SyntheticRubber::kReference;
    }
}

}  // namespace asperity
