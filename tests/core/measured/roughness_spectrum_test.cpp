// Spectra of profiles and topographies; the line of an isotropic surface from its topography and
// from profiles cut from it (C_line = pi q C2, the Abel relation).
#include "core/measured/roughness_spectrum.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
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

double squareOf(const std::vector<double>& magnitudes) {
  double square = 0;
  for (const double magnitude : magnitudes) square += 2 * magnitude * magnitude;
  return square;
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
  EXPECT_NEAR(squareOf(modes) / (2 * density.integral()), 1, 1e-12);
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

/// A table of the waves k step of a periodogram.
SpectralDensity periodogram(int waves, double step, const std::function<double(int)>& value) {
  SpectralDensity density;
  for (int k = 1; k <= waves; ++k) {
    density.waveNumber.push_back(k * step);
    density.density.push_back(value(k));
  }
  density.binEdge = findBinEdges(density.waveNumber);
  return density;
}

/// <h^2> = 2 sum C1 dq, whose values are distributed exponentially (chi-squared, two degrees of
/// freedom): to each wave of the line what its bin has, and as much to a line ten times as long.
TEST(SpectralDensity, OfAPeriodogramKeepsTheSumOfItsBins) {
  std::mt19937 random(3);
  std::exponential_distribution<double> scatter;
  const double step = 500, length = 2 * std::numbers::pi / step;
  double sum = 0;
  const SpectralDensity density = periodogram(2000, step, [&](int k) {
    const double value = std::pow(k, -2.4) * scatter(random);
    sum += value * step;
    return value;
  });
  EXPECT_NEAR(density.integral() / sum, 1, 1e-12);
  const auto modes = modeMagnitudes(density, length, 2000);
  for (std::size_t k = 0; k < modes.size(); ++k)
    EXPECT_NEAR(modes[k] * modes[k], density.density[k] * step, 1e-14 * sum) << k;
  EXPECT_NEAR(squareOf(modeMagnitudes(density, 10 * length, 20005)) / (2 * sum), 1, 1e-12);
}

/// The bins of a smooth density are those of a midpoint rule: C dq (1 + a (a - 1) / 24 (dq / q)^2)
/// in the bin at q for C = q^a.
TEST(SpectralDensity, OfSmoothBinsIsTheMidpointRule) {
  const double exponent = -2.4, step = 1;
  SpectralDensity density = periodogram(1000, step, [&](int k) { return std::pow(k, exponent); });
  for (const int first : {5, 20, 100}) {
    const SpectralDensity part = within(density, first - 0.5, HUGE_VAL);
    const double exact =
        (std::pow(1000.5, exponent + 1) - std::pow(first - 0.5, exponent + 1)) / (exponent + 1);
    const double allowed = exponent * (exponent - 1) / 24 / std::pow(first - 0.5, 2);
    EXPECT_NEAR(part.integral() / exact, 1, allowed) << first;
  }
}

TEST(SpectralDensity, HasBinsOnlyWhereTheWavesAreMultiplesOfOneStep) {
  const auto waves = [](int points, const std::function<double(double)>& wave) {
    std::vector<double> q;
    for (int i = 0; i < points; ++i) q.push_back(wave(i));
    return q;
  };
  const auto isBinned = [&](int points, const std::function<double(double)>& wave) {
    return !findBinEdges(waves(points, wave)).empty();
  };
  EXPECT_TRUE(isBinned(4, [](double i) { return 700 * (i + 1); }));
  EXPECT_TRUE(isBinned(900, [](double i) { return 700 * (i + 3); }));
  // Five digits, and a row that is missing.
  EXPECT_TRUE(isBinned(
      4000, [](double i) { return std::stod(fmt::format("{:.4e}", 785.39816 * (i + 1))); }));
  EXPECT_TRUE(isBinned(100, [](double i) { return i < 40 ? i + 1 : i + 2; }));
  EXPECT_FALSE(isBinned(3, [](double i) { return i + 1; }));
  EXPECT_FALSE(isBinned(50, [](double i) { return std::pow(10, i / 10); }));
  EXPECT_FALSE(isBinned(1000, [](double i) { return 10 + 999.0 * i; }));  // from far below a step
  EXPECT_FALSE(isBinned(1000, [](double i) { return 1.4 + i; }));
  // Bins meet half-way, and the outermost are as wide as the others.
  const auto edges = findBinEdges(waves(4, [](double i) { return 2 * (i + 1); }));
  EXPECT_EQ(edges, (std::vector<double>{1, 3, 5, 7, 9}));
}

TEST(SpectralDensity, IsCutWithinItsBins) {
  const SpectralDensity density = periodogram(10, 1, [](int k) { return k; });
  const SpectralDensity part = within(density, 2.25, 3.75);
  EXPECT_EQ(part.density, (std::vector<double>{2, 3, 4}));
  EXPECT_EQ(part.binEdge, (std::vector<double>{2.25, 2.5, 3.5, 3.75}));
  EXPECT_NEAR(part.integral(), 0.5 + 3 + 1, 1e-14);
  EXPECT_TRUE(within(density, 20, 30).empty());
  EXPECT_EQ(within(density, 20, 30).integral(), 0);
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

/// A steep spectrum in bands has the power of each band, and not only that of all.
TEST(Bands, HaveADensityWithTheirPowers) {
  for (const double exponent : {0.0, -1.6, -2.6, -3.0}) {
    std::vector<double> powers{0};
    for (int k = 1; k <= 512; ++k) powers.push_back(std::pow(k, exponent));
    const BandPowers bands = inBands(powers, 1e-3);
    const SpectralDensity density = bands.density();
    EXPECT_NEAR(2 * density.integral() / bands.total(), 1, 1e-12);
    for (std::size_t j = 0; j < bands.bands(); ++j) {
      const double its = 2 * (density.integralTo(bands.to(j)) - density.integralTo(bands.from(j)));
      EXPECT_NEAR(its / bands.power[j], 1, 0.01) << exponent << ", band " << j;
    }
  }
}

TEST(EquivalentLine, OfTopographiesHasTheirHeightAndGradient) {
  const IsotropicSurface surface;
  double height = 0, slope = 0;
  constexpr int kSurfaces = 40;
  const std::vector<double> amplitudes = surface.amplitudes();
  for (unsigned r = 0; r < kSurfaces; ++r) {
    const EquivalentSpectra spectra =
        equivalentSpectra(surface.make(r + 1, amplitudes), FormRemoval::None);
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
  const std::vector<double> amplitudes = surface.amplitudes();
  for (unsigned r = 0; r < 20; ++r) {
    const Topography topography = surface.make(r + 1, amplitudes);
    for (std::int64_t row = 12; row < topography.rows; row += 25, ++cuts) {
      const BandPowers cut =
          equivalentSpectra(inBands(hannPowers(topography.row(row)), topography.length())).line;
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
  const EquivalentSpectra spectra = equivalentSpectra(inBands(powers, 1));
  const double expected =
      std::sqrt(std::numbers::pi) * std::tgamma(1 + hurst) / std::tgamma(hurst + 0.5);
  for (const double k : {20.0, 100.0, 400.0})
    EXPECT_NEAR(std::pow(spectra.factor(2 * std::numbers::pi * k), 2) / expected, 1, 0.02) << k;
}

}  // namespace
}  // namespace asperity
