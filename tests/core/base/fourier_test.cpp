// Fourier transforms: closed forms, the way back, and plans that are kept.
#include "core/base/fourier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>

namespace asperity {
namespace {

std::vector<double> wave(std::size_t points, std::size_t mode, double amplitude, double phase) {
  std::vector<double> values(points);
  for (std::size_t j = 0; j < points; ++j)
    values[j] = amplitude * std::cos(2 * std::numbers::pi * static_cast<double>(j * mode % points) /
                                         static_cast<double>(points) +
                                     phase);
  return values;
}

/// X_k = n a e^(i phase) / 2 for x_j = a cos(2 pi j k / n + phase), and 0 for any other mode.
TEST(Fourier, AWaveIsOneMode) {
  for (const std::size_t points : {7, 64, 1000, 1009}) {
    const auto modes = RealTransform(points).forward(wave(points, 3, 0.2, 0.7));
    ASSERT_EQ(modes.size(), points / 2 + 1);
    for (std::size_t k = 0; k < modes.size(); ++k) {
      const std::complex<double> exact =
          k == 3 ? std::polar(0.1 * static_cast<double>(points), 0.7) : 0.0;
      EXPECT_LT(std::abs(modes[k] - exact), 1e-12 * static_cast<double>(points))
          << points << ", " << k;
    }
  }
}

TEST(Fourier, TheWayBackGivesTheNumbersTimesTheirCount) {
  for (const std::size_t points : {5, 48, 243}) {
    const RealTransform transform(points);
    const std::vector<double> values = wave(points, 2, 3, 0.1);
    const std::vector<double> back = transform.backward(transform.forward(values));
    for (std::size_t j = 0; j < points; ++j)
      EXPECT_NEAR(back[j], static_cast<double>(points) * values[j],
                  1e-13 * static_cast<double>(points));
  }
}

TEST(Fourier, FastSizesHaveSmallPrimeFactors) {
  EXPECT_EQ(fastTransformSize(1), 1U);
  EXPECT_EQ(fastTransformSize(7), 8U);
  EXPECT_EQ(fastTransformSize(1000), 1000U);
  EXPECT_EQ(fastTransformSize(1001), 1024U);
}

TEST(Fourier, PlansOfASizeAreMadeOnce) {
  using Arrays = FourierPlans::Arrays;
  const auto plans = FourierPlans::forSize(360, Arrays::Any);
  EXPECT_EQ(FourierPlans::forSize(360, Arrays::Any), plans);
  EXPECT_NE(FourierPlans::forSize(360, Arrays::Aligned), plans);
  EXPECT_NE(FourierPlans::forSize(361, Arrays::Any), plans);
}

/// A kept plan ends when the last of its users does, however many sizes came after it.
TEST(Fourier, PlansOutliveTheListOfThoseThatAreKept) {
  const RealTransform transform(300);
  const std::vector<double> values = wave(300, 5, 1, 0.3);
  const auto before = transform.forward(values);
  for (std::size_t points = 10; points < 60; ++points)
    FourierPlans::forSize(points, FourierPlans::Arrays::Any);
  EXPECT_EQ(transform.forward(values), before);
  EXPECT_EQ(RealTransform(300).forward(values), before);
}

TEST(Fourier, ManyThreadsGetPlansOfManySizesAtOnce) {
  const auto work = [](std::size_t first) {
    for (std::size_t points = first; points < 200; points += 7) {
      const auto modes = RealTransform(points).forward(wave(points, 1, 1, 0));
      EXPECT_NEAR(modes[1].real(), 0.5 * static_cast<double>(points), 1e-10);
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < 4; ++i) threads.emplace_back(work, 20 + i);
}

}  // namespace
}  // namespace asperity
