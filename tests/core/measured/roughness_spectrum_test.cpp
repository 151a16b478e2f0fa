// Spectra of profiles and topographies; the line of an isotropic surface from its topography and
// from profiles cut from it (C_line = pi q C2, the Abel relation).
#include "core/measured/roughness_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/measured/processing.h"
#include "tests/core/isotropic_surface.h"

namespace asperity {
namespace {

SpectralDensity powerLaw(double from, double to, int points, double exponent) {
  SpectralDensity density;
  for (int i = 0; i < points; ++i) {
    const double q = from * std::pow(to / from, i / (points - 1.0));
    density.waveNumber.push_back(q);
    density.density.push_back(std::pow(q, exponent));
  }
  return density;
}

TEST(SpectralDensity, IsIntegratedAsAPowerLawExactly) {
  for (const double exponent : {-2.4, -1.0, 0.0, 1.5}) {
    const SpectralDensity density = powerLaw(1, 1000, 4, exponent);
    const double exact =
        exponent == -1 ? std::log(500.0) : (std::pow(500.0, exponent + 1) - 1) / (exponent + 1);
    EXPECT_NEAR(density.integralTo(500) / exact, 1, 1e-12) << exponent;
  }
}

/// <h^2> = 2 integral C1 dq, over the band that the modes cover.
TEST(SpectralDensity, GivesItsHeightToTheModesOfALine) {
  const SpectralDensity density = powerLaw(100, 1e5, 30, -2.4);
  const double length = 2 * std::numbers::pi / 10;  // ten times the longest wave
  const auto modes = modeMagnitudes(density, length, 20000);
  double square = 0;
  for (const double magnitude : modes) square += 2 * magnitude * magnitude;
  EXPECT_NEAR(square / (2 * density.integralTo(1e5)), 1, 1e-12);
  EXPECT_EQ(modes[4], 0);  // 50 1/m, below the table
  EXPECT_EQ(modes[11000], 0);
}

TEST(SpectralDensity, IsCutAtWaveNumbersBetweenItsPoints) {
  const SpectralDensity all = powerLaw(1, 100, 3, -2);
  const SpectralDensity part = within(all, 5, 20);
  EXPECT_DOUBLE_EQ(part.waveNumber.front(), 5);
  EXPECT_DOUBLE_EQ(part.waveNumber.back(), 20);
  EXPECT_NEAR(part.density.front(), 1.0 / 25, 1e-15);
  EXPECT_NEAR(part.integralTo(20), 1.0 / 5 - 1.0 / 20, 1e-13);
}

/// Parseval: under the window the powers add up to the mean square of noise, on average.
TEST(HannSpectrum, KeepsThePowerOfNoise) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  double sum = 0;
  for (int r = 0; r < 200; ++r) {
    std::vector<double> heights(255);
    for (double& height : heights) height = normal(random);
    for (const double power : hannPowers(heights)) sum += power / 200;
  }
  EXPECT_NEAR(sum, 1, 0.03);
}

TEST(HannSpectrum, FindsWhereWhiteNoiseBegins) {
  // C1 ~ q^-3 from random phases, and noise that meets it at a tenth of the highest wave number.
  const std::size_t points = 4096;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
  std::vector<double> heights(points), clean;
  for (int k = 1; k < 1000; ++k) {
    const double shift = phase(random), amplitude = std::pow(k, -1.5);
    for (std::size_t i = 0; i < points; ++i)
      heights[i] +=
          amplitude * std::cos(2 * std::numbers::pi * k * static_cast<double>(i) / points + shift);
  }
  clean = heights;
  const double meeting = 200;  // noise power of each wave, sigma^2 2 / n, is that of this wave
  const double sigma = std::sqrt(0.5 * std::pow(meeting, -3.0) * points / 2.0);
  for (double& height : heights) height += sigma * normal(random);
  const double lowest = 2 * std::numbers::pi / points;
  const ReliableBand noisy = reliableBand(heights, 1, 0);
  EXPECT_TRUE(noisy.endsInNoise);
  EXPECT_GT(noisy.to / lowest, 0.3 * meeting);
  EXPECT_LT(noisy.to / lowest, 3 * meeting);
  EXPECT_NEAR(noisy.from / lowest, 3, 1e-9);
  EXPECT_NEAR(reliableBand(clean, 1, 16).to, 2 * std::numbers::pi / 16, 1e-9);
}

/// The harmonics of a machined surface are no noise, however few points its period has.
TEST(HannSpectrum, TakesNoHarmonicsForNoise) {
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  for (const int points : {1000, 4096})
    for (const double period : {6.5, 13.0, 29.3})
      for (const double noise : {0.0, 0.01}) {
        std::vector<double> heights(static_cast<std::size_t>(points));
        for (std::size_t i = 0; i < heights.size(); ++i)
          heights[i] = std::fmod(static_cast<double>(i), period) / period + noise * normal(random);
        EXPECT_FALSE(reliableBand(heights, 1e-5, 0).endsInNoise)
            << points << ' ' << period << ' ' << noise;
      }
}

TEST(HannSpectrum, TakesASmoothLineWithWhiteNoiseForNoise) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const int points : {300, 4096, 30000}) {
    std::vector<double> heights(static_cast<std::size_t>(points));
    for (double& height : heights) height = normal(random);
    EXPECT_TRUE(reliableBand(heights, 1, 0).endsInNoise) << points;
  }
}

TEST(Bands, HoldEveryPowerOnce) {
  std::vector<double> powers(1000, 1.0);
  const BandPowers bands = inBands(powers, 1);
  EXPECT_DOUBLE_EQ(bands.total(), 1000);
  EXPECT_EQ(bands.first.back(), 1000U);
  EXPECT_LT(bands.bands(), 40U);
}

double squareSlope(const BandPowers& bands) {
  return bands.rmsSlope() * bands.rmsSlope();
}

TEST(EquivalentLine, OfTopographiesHasTheirHeightAndGradient) {
  const IsotropicSurface surface;
  double height = 0, slope = 0;
  constexpr int kSurfaces = 40;
  for (unsigned r = 0; r < kSurfaces; ++r) {
    const EquivalentSpectra spectra = equivalentOf(surface.make(r + 1), FormRemoval::None);
    height += spectra.line.total() / kSurfaces;
    slope += squareSlope(spectra.line) / kSurfaces;
  }
  EXPECT_NEAR(height / (surface.height * surface.height), 1, 0.02);
  EXPECT_NEAR(slope / surface.squareGradient(), 1, 0.02);
}

/// The Abel relation gives the same line from profiles alone.
TEST(EquivalentLine, OfCutProfilesIsThatOfTheirSurface) {
  const IsotropicSurface surface;
  double height = 0, slope = 0;
  int cuts = 0;
  for (unsigned r = 0; r < 20; ++r) {
    const Topography topography = surface.make(r + 1);
    for (std::int64_t row = 12; row < topography.rows; row += 25, ++cuts) {
      const BandPowers cut =
          equivalentOf(inBands(hannPowers(topography.row(row)), topography.length())).line;
      height += cut.total();
      slope += squareSlope(cut);
    }
  }
  EXPECT_GE(cuts, 200);
  // The powers cannot be below 0, which moves a little of them from short to long waves.
  EXPECT_NEAR(std::sqrt(height / cuts) / surface.height, 1, 0.03);
  EXPECT_NEAR(std::sqrt(slope / cuts / surface.squareGradient()), 1, 0.03);
}

/// For a self-affine spectrum C_line / C_prof = sqrt(pi) Gamma(1 + H) / Gamma(H + 1/2).
TEST(EquivalentLine, OfASelfAffineProfileHasTheKnownFactor) {
  const double hurst = 0.7;
  const std::size_t modes = 4096;
  std::vector<double> powers(modes);
  for (std::size_t k = 1; k < modes; ++k)
    powers[k] = std::pow(static_cast<double>(k), -1 - 2 * hurst);
  const EquivalentSpectra spectra = equivalentOf(inBands(powers, 1));
  const double expected =
      std::sqrt(std::numbers::pi) * std::tgamma(1 + hurst) / std::tgamma(hurst + 0.5);
  for (const double k : {20.0, 100.0, 400.0})
    EXPECT_NEAR(std::pow(spectra.factor(2 * std::numbers::pi * k), 2) / expected, 1, 0.02) << k;
}

}  // namespace
}  // namespace asperity
