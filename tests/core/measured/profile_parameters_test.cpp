// ISO 21920-2 parameters against closed forms of a sine and a triangle.
#include "core/measured/profile_parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace asperity {
namespace {

/// A sine of amplitude A: Pa = 2 A / pi, Pq = A / sqrt 2, Psk = 0, Pku = 3/2, Pz = 2 A,
/// Pdq = sqrt 2 pi A / lambda.
TEST(ProfileParameters, OfASineAreItsClosedForms) {
  const double amplitude = 2e-6, spacing = 1e-6, wavelength = 2e-4;
  std::vector<double> heights;
  for (int i = 0; i < 10000; ++i)
    heights.push_back(4e-3 + amplitude * std::sin(2 * std::numbers::pi * i * spacing / wavelength));
  const ProfileParameters values = profileParameters(heights, spacing);
  EXPECT_NEAR(values.pa / amplitude, 2 / std::numbers::pi, 1e-3);
  EXPECT_NEAR(values.pq / amplitude, 1 / std::numbers::sqrt2, 1e-9);
  EXPECT_NEAR(values.psk, 0, 1e-6);
  EXPECT_NEAR(values.pku, 1.5, 1e-6);
  EXPECT_NEAR(values.pz / amplitude, 2, 1e-9);
  // Three points at each end, where the sine is steepest, have no slope by seven points.
  EXPECT_NEAR(values.pdq * wavelength / amplitude / (std::numbers::sqrt2 * std::numbers::pi), 1,
              5e-4);
  EXPECT_DOUBLE_EQ(values.length, 0.01);
}

/// A triangle of height 2 A and period lambda: Pa = A / 2, Pq = A / sqrt 3, Pku = 9/5,
/// Pdq = 4 A / lambda, less what seven points round off at the corners.
TEST(ProfileParameters, OfATriangleAreItsClosedForms) {
  const double amplitude = 1e-6, spacing = 1e-7;
  const int wave = 2000;
  std::vector<double> heights;
  for (int i = 0; i < 20 * wave; ++i) {
    const double part = (i % wave) / static_cast<double>(wave);
    heights.push_back(amplitude * (part < 0.5 ? 4 * part - 1 : 3 - 4 * part));
  }
  const ProfileParameters values = profileParameters(heights, spacing);
  EXPECT_NEAR(values.pa / amplitude, 0.5, 1e-5);
  EXPECT_NEAR(values.pq / amplitude, 1 / std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(values.psk, 0, 1e-6);
  EXPECT_NEAR(values.pku, 1.8, 1e-5);
  EXPECT_NEAR(values.pz / amplitude, 2, 1e-9);
  EXPECT_NEAR(values.pdq, 4 * amplitude / (wave * spacing),
              2e-3 * 4 * amplitude / (wave * spacing));
}

/// Rz is the mean of the maximum heights of sections of the cut-off wavelength.
TEST(ProfileParameters, TakeTheMaximumHeightInEachSection) {
  std::vector<double> heights(300, 0.0);
  heights[50] = 3;    // 3 in the first section,
  heights[150] = -5;  // 5 in the second,
  heights[250] = 1;   // 1 in the third
  const ProfileParameters values = profileParameters(heights, 1, 100);
  EXPECT_DOUBLE_EQ(values.pz, 3);
  EXPECT_DOUBLE_EQ(values.pt, 8);
  EXPECT_DOUBLE_EQ(profileParameters(heights, 1).pz, 8);
}

TEST(ProfileParameters, LeaveGapsOut) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const ProfileParameters values =
      profileParameters(std::vector<double>{1, none, -1, 1, none, -1, none}, 1);
  EXPECT_DOUBLE_EQ(values.pa, 1);
  EXPECT_DOUBLE_EQ(values.pq, 1);
  EXPECT_DOUBLE_EQ(values.pz, 2);
}

}  // namespace
}  // namespace asperity
