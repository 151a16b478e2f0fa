#include "core/contact/line/polynomial.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace asperity {
namespace {

template <int N>
std::vector<double> listOf(const StaticVector<N>& few) {
  return {few.begin(), few.end()};
}

Cubic withZeros(double a, double b, double c, double factor) {
  return {-a * b * c * factor, (a * b + b * c + c * a) * factor, -(a + b + c) * factor, factor};
}

TEST(Polynomial, EveryZeroInsideIsFoundInOrder) {
  for (const double factor : {1.0, -3e-9, 1e12}) {
    const auto zeros = listOf(zerosInside(withZeros(0.1, 0.4, 0.9, factor)));
    ASSERT_EQ(zeros.size(), 3U);
    EXPECT_NEAR(zeros[0], 0.1, 1e-14);
    EXPECT_NEAR(zeros[1], 0.4, 1e-14);
    EXPECT_NEAR(zeros[2], 0.9, 1e-14);
    EXPECT_EQ(listOf(zerosInside(withZeros(-0.1, 0.5, 1.9, factor))).size(), 1U);
    EXPECT_TRUE(listOf(zerosInside(withZeros(-0.1, -0.5, 1.9, factor))).empty());
  }
}

TEST(Polynomial, LowerDegreesAreNoSpecialCase) {
  EXPECT_THAT(listOf(zerosInside({-1, 4, 0, 0})), testing::ElementsAre(0.25));
  EXPECT_EQ(listOf(zerosInside({0.02, -0.3, 1, 0})).size(), 2U);
  EXPECT_TRUE(listOf(zerosInside({1, 0, 0, 0})).empty());
  EXPECT_TRUE(listOf(stationaryPoints({0, 0, 0, 0})).empty());
  EXPECT_TRUE(listOf(stationaryPoints({1, 2, 0, 0})).empty());
}

TEST(Polynomial, StationaryPointsDoNotCancel) {
  // 3 c3 t^2 + 2 c2 t + c1 with a tiny leading term: the small zero must keep its digits.
  const auto points = listOf(stationaryPoints({0, -0.3, 0.5, 1e-14}));
  ASSERT_EQ(points.size(), 1U);
  EXPECT_NEAR(points[0], 0.3, 1e-12);
}

TEST(Polynomial, IntegralsAgreeWithSums) {
  const Cubic cubic{1, -2, 3, -4};
  const int n = 200000;
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const double t = 0.7 * (i + 0.5) / n;
    sum += cubic(t) * 0.7 / n;
    squares += cubic.derivative(t) * cubic.derivative(t) * 0.7 / n;
  }
  EXPECT_NEAR(cubic.integral(0.7), sum, 1e-9);
  EXPECT_NEAR(cubic.integralOfSlopeSquared(0.7), squares, 1e-8);
}

TEST(Polynomial, ShiftedOriginIsTheSamePolynomial) {
  const Cubic cubic{1, -2, 3, -4};
  for (const double t : {0.0, 0.2, 0.5}) EXPECT_NEAR(cubic.about(0.3)(t), cubic(0.3 + t), 1e-15);
}

TEST(Polynomial, BracketedZeroSurvivesSteepAndFlatFunctions) {
  const auto steep = [](double t, double& derivative) {
    derivative = 1e6 * std::exp(-1e6 * t);
    return 0.5 - std::exp(-1e6 * t);
  };
  EXPECT_NEAR(zeroBetween(0, 1, -0.5, steep) * 1e6, std::log(2.0), 1e-9);
}

/// Two dips between ends that rise and fall: the first one is found, in either direction.
TEST(Polynomial, TheFirstZeroIsFoundWhateverTheSlopesAtTheEndsAre) {
  constexpr double kWaves = 4 * std::numbers::pi;
  const auto firstIn = [](double from, double to, const auto& function) {
    const auto value = [&](double t, double& slope) {
      const ValueAndSlope at = function(t);
      slope = at.slope;
      return at.value;
    };
    return firstZero(from, function(from), to, function(to), function,
                     [&](double a, ValueAndSlope, double b, ValueAndSlope atB) {
                       return a < b ? zeroBetween(a, b, 1, value)
                                    : zeroBetween(b, a, atB.value, value);
                     });
  };
  for (const double level : {0.5, 0.99, 0.999999}) {
    const auto dips = [&](double t) {
      return ValueAndSlope{level + std::sin(kWaves * t), kWaves * std::cos(kWaves * t)};
    };
    const double half = std::acos(level) / kWaves;  // of a dip's width
    EXPECT_NEAR(firstIn(0, 1, dips), 0.375 - half, 1e-9);
    EXPECT_NEAR(firstIn(1, 0, dips), 0.875 + half, 1e-9);
  }
  const auto above = [&](double t) {
    return ValueAndSlope{1.001 + std::sin(kWaves * t), kWaves * std::cos(kWaves * t)};
  };
  EXPECT_EQ(firstIn(0, 1, above), kNoZero);
  // The search ends where the function is 0 to rounding.
  int looks = 0;
  const auto around0 = [&](double t) {
    ++looks;
    return ValueAndSlope{1e-20 * std::cos(1e12 * t), -1e-8 * std::sin(1e12 * t)};
  };
  firstIn(0, 1, around0);
  EXPECT_LT(looks, 1000);
  // Without numbers there is no zero, and nothing to halve.
  looks = 0;
  const auto noNumber = [&](double t) {
    ++looks;
    return ValueAndSlope{t < 1 ? 1 : std::numeric_limits<double>::quiet_NaN(), 0};
  };
  EXPECT_EQ(firstIn(0, 1, noNumber), kNoZero);
  EXPECT_EQ(looks, 2);
  EXPECT_EQ(firstIn(1, 0, above), kNoZero);
}

}  // namespace
}  // namespace asperity
