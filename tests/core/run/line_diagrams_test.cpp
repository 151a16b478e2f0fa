// The spectrum read back from lines, and statistics in contact.
#include "core/run/line_diagrams.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/run/steady_frames.h"
#include "tests/core/temporary_folder.h"

namespace asperity {
namespace {

Frame steadyFrame(double velocity, double force = 0.02) {
  Scene scene;
  scene.surface.elements = 2000;
  scene.load.normalForce = force;
  scene.sliding.velocity = velocity;
  return SteadyFrames(std::make_shared<const Scene>(scene), {.lineSlope = true}).frame(0, 1, 25);
}

/// Amplitudes are not random, so the exponent comes back to rounding.
TEST(Spectrum, GivesTheHurstExponentBack) {
  for (const double hurst : {0.0, 0.3, 0.7, 1.0}) {
    Scene scene;
    scene.surface.hurst = hurst;
    scene.surface.elements = 1000;
    const SpectrumReading reading = readSpectrum(scene);
    ASSERT_TRUE(reading.hasFit);
    EXPECT_NEAR(reading.hurst(), hurst, 1e-9);
  }
}

/// h^2 = 2 integral C dq: the fitted law carries the line's own height.
TEST(Spectrum, HasTheScaleOfTheHeights) {
  Scene scene;
  scene.surface.elements = 1000;
  const SpectrumReading reading = readSpectrum(scene);
  const double lowest = 2 * std::numbers::pi / scene.surface.length;
  double square = 0;
  for (int k = 1; k < 500; ++k)
    square +=
        2 * lowest * std::exp(reading.fit.intercept + reading.fit.slope * std::log(lowest * k));
  EXPECT_NEAR(std::sqrt(square), scene.surface.rmsHeight, 1e-6 * scene.surface.rmsHeight);
}

TEST(Spectrum, IsFittedAboveTheRollOff) {
  Scene scene;
  scene.surface.rollOffWavelength = 1e-3;
  const SpectrumReading reading = readSpectrum(scene);
  EXPECT_NEAR(reading.fitFrom, 2 * std::numbers::pi / 1e-3, 1e-6);
  EXPECT_NEAR(reading.hurst(), scene.surface.hurst, 1e-9);
}

/// A measured line has a roll-off and a cut-off: C is constant up to q1, falls as q^(-2H-1) to q2,
/// and is almost 0 above.
TEST(Spectrum, OfAFileIsFittedWhereItFollowsAPowerLaw) {
  constexpr double kLength = 0.04, kHurst = 0.8, kRollOff = 2e3, kCutOff = 6e4;  // m, 1, 1/m, 1/m
  constexpr int kPoints = 4000;
  TemporaryFolder folder;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
  std::vector<double> heights(kPoints);
  for (int mode = 1; mode < kPoints / 2; ++mode) {
    const double q = 2 * std::numbers::pi * mode / kLength;
    const double cutOff = q > kCutOff ? 1e-6 : 1;
    const double density = cutOff * std::pow(std::max(q, kRollOff) / kRollOff, -2 * kHurst - 1);
    const double shift = phase(random);
    for (int i = 0; i < kPoints; ++i)
      heights[i] +=
          1e-6 * std::sqrt(density) * std::cos(2 * std::numbers::pi * mode * i / kPoints + shift);
  }
  std::string text = "x (m),z (m)\n";
  for (int i = 0; i < kPoints; ++i)
    text += fmt::format("{:.17g},{:.17g}\n", kLength * i / kPoints, heights[i]);
  folder.write("profile.csv", text);
  Scene scene;
  scene.surface.kind = SurfaceKind::Profile;
  scene.surface.file = "profile.csv";
  scene.folder = folder.path();
  scene.surface.length = 0;
  scene.surface.elements = 0;
  const SpectrumReading reading = readSpectrum(scene);
  ASSERT_TRUE(reading.hasFit);
  EXPECT_NEAR(reading.hurst(), kHurst, 0.1);
  EXPECT_GT(reading.fitFrom, kRollOff / 2);
  EXPECT_LT(reading.fitTo, kCutOff * 1.2);
}

/// The corners of a wedge: c_k ~ 1/k^2 for odd k, so C ~ q^-4 and H = 1.5.
TEST(Spectrum, OfAWedgeIsThatOfItsCorner) {
  Scene scene;
  scene.surface.kind = SurfaceKind::Wedge;
  scene.surface.slope = 1e-3;
  scene.surface.elements = 4096;
  EXPECT_NEAR(readSpectrum(scene).hurst(), 1.5, 0.1);
}

TEST(Spectrum, OfASineIsOnePoint) {
  Scene scene;
  scene.surface.kind = SurfaceKind::Sine;
  const SpectrumReading reading = readSpectrum(scene);
  EXPECT_FALSE(reading.hasFit);
  ASSERT_EQ(reading.waveNumber.size(), 1U);
  EXPECT_NEAR(
      reading.waveNumber[0],
      static_cast<double>(scene.surface.waves) * 2 * std::numbers::pi / scene.surface.length, 1e-6);
  EXPECT_EQ(spectrumSheet(scene).diagrams[0].series.size(), 1U);
}

TEST(Spectrum, SheetShowsWantedAndFitted) {
  const DiagramSheet sheet = spectrumSheet({});
  ASSERT_EQ(sheet.diagrams.size(), 1U);
  ASSERT_EQ(sheet.diagrams[0].series.size(), 3U);
  EXPECT_EQ(sheet.diagrams[0].series[0].name.english(), "prescribed, H = 0.7");
  EXPECT_EQ(sheet.diagrams[0].series[2].name.english(), "fitted, H = 0.700");
  for (const DiagramSeries& series : sheet.diagrams[0].series)
    EXPECT_LT(series.points.size(), 100U);
}

TEST(Histogram, SharesAddUpToWhatIsInside) {
  const Histogram histogram = makeHistogram({0, 0.1, 0.49, 0.5, 0.99, 1, -3}, 0, 1, 2);
  EXPECT_NEAR(histogram.share[0], 3.0 / 7, 1e-12);
  EXPECT_NEAR(histogram.share[1], 2.0 / 7, 1e-12);
  EXPECT_EQ(makeHistogram({}, 0, 1, 3).share, std::vector<double>(3));
}

/// Slopes of random phases are normally distributed.
TEST(SlopeStatistics, OfTheWholeLineAreNormal) {
  const SlopeStatistics slopes = slopeStatistics(steadyFrame(1));
  double mean = 0, square = 0, whole = 0, x = slopes.whole.from + 0.5 * slopes.whole.width();
  for (const double share : slopes.whole.share) {
    whole += share;
    mean += share * x;
    square += share * x * x;
    x += slopes.whole.width();
  }
  EXPECT_NEAR(whole, 1, 1e-3);
  EXPECT_NEAR(mean, 0, 0.02);
  EXPECT_NEAR(square - std::pow(slopes.whole.width(), 2) / 12, 1, 0.015);  // Sheppard's correction
}

/// At low velocity contact lies on both sides of its asperities; on the plateau the elastomer
/// behaves like a fluid and all contacts are one-sided (Li et al. 2013, Eq. 10).
TEST(SlopeStatistics, ContactBecomesOneSided) {
  const double slow = slopeStatistics(steadyFrame(1e-4)).climbing;
  const double middle = slopeStatistics(steadyFrame(1)).climbing;
  const double plateau = slopeStatistics(steadyFrame(50)).climbing;
  EXPECT_NEAR(slow, 0.5, 0.08);
  EXPECT_GT(middle, slow + 0.05);
  EXPECT_GT(plateau, 0.97);
}

/// rms slope in contact as the steady pass has it.
TEST(SlopeStatistics, AgreeWithTheSteadyPass) {
  Scene scene;
  scene.surface.elements = 2000;
  scene.load.normalForce = 0.5;
  const SteadyFrames frames(std::make_shared<const Scene>(scene), {.lineSlope = true});
  const Frame frame = frames.frame(0, 1, 25);
  EXPECT_NEAR(slopeStatistics(frame).rmsContact, frames.result().rmsSlopeContact / frame.rmsSlope,
              0.02);
}

TEST(SlopeStatistics, BackwardsTheOtherSideClimbs) {
  Frame frame = steadyFrame(1);
  const double forwards = slopeStatistics(frame).climbing;
  frame.velocity = -1;
  EXPECT_NEAR(slopeStatistics(frame).climbing, 1 - forwards, 1e-12);
}

TEST(Statistics, NothingBreaksWithoutContactOrPoints) {
  EXPECT_EQ(statisticsSheet({}).diagrams.size(), 2U);
  Frame frame = steadyFrame(1);
  std::fill(frame.pressure.begin(), frame.pressure.end(), 0.0);
  EXPECT_EQ(statisticsSheet(frame).note.english(), "No element is in contact.");
}

/// p L_c = F_N, whatever the scheme and however few elements are in contact; where they are enough
/// the shares have that mean, too.
TEST(Statistics, MeanPressureTimesContactLengthIsTheNormalForce) {
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic})
    for (const double force : {1e-4, 0.2, 30.0})
      for (const double velocity : {1e-3, 1.0, 100.0}) {
        Scene scene;
        scene.surface.elements = 2000;
        scene.load.normalForce = force;
        scene.sliding.velocity = velocity;
        scene.accuracy.scheme = scheme;
        const Frame frame = SteadyFrames(std::make_shared<const Scene>(scene), {}).frame(0, 1, 25);
        const Diagram pressures = statisticsSheet(frame).diagrams[0];
        if (pressures.series.empty()) {  // contact between two points
          EXPECT_LT(frame.state.contactFraction, 1e-3);
          continue;
        }
        const double mean = pressures.series[1].points[0].x;
        EXPECT_NEAR(mean * frame.state.contactFraction * frame.length / force, 1, 1e-12);
        const std::vector<DiagramPoint>& steps = pressures.series[0].points;
        double sum = 0, shares = 0;
        for (std::size_t i = 1; i + 1 < steps.size(); i += 2) {
          sum += steps[i].y * 0.5 * (steps[i].x + steps[i + 1].x);
          shares += steps[i].y;
        }
        if (frame.state.contactFraction < 0.02) continue;
        // The hundredth of the length under the highest pressures is not shown.
        EXPECT_LT(sum / shares / mean, 1.01);
        EXPECT_GT(sum / shares / mean, 0.95) << force << " N, " << velocity << " m/s";
      }
}

/// The curve of pressures encloses all elements but the last percent.
TEST(Statistics, PressuresAddUp) {
  const DiagramSheet sheet = statisticsSheet(steadyFrame(1));
  const std::vector<DiagramPoint>& steps = sheet.diagrams[0].series[0].points;
  double whole = 0;
  for (std::size_t i = 1; i + 1 < steps.size(); i += 2) whole += steps[i].y;
  EXPECT_GT(whole, 98.5);
  EXPECT_LE(whole, 100 + 1e-9);
}

}  // namespace
}  // namespace asperity
