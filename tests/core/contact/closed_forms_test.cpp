// Isolated shapes against their closed forms (Kelvin elements, p > 0), and Eq. (8).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/surface/line.h"
#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

struct Forces {
  double normal, tangential;  // N
};

/// Wedge z = t |x| at depth d, c = v tau.
Forces wedgeForces(double t, double d, double c) {
  const double a = d / t, g = kModulus;
  const double normal = 4 * g * t * (c <= a ? a * a + c * c / 2 : a * a / 2 + a * c);
  const double tangential = c <= a ? 4 * g * t * t * (2 * a * c - c * c / 2) : t * normal;
  return {normal, tangential};
}

/// Parabola z = x^2 / 2R.
Forces parabolaForces(double radius, double d, double c) {
  const double g = kModulus, a = std::sqrt(2 * radius * d), b = std::hypot(a, c) - c;
  const double edge = a * a - b * b;
  return {2 * g / radius * (a * a * (a + b) - (a * a * a + b * b * b) / 3 + c * edge),
          4 * g / (radius * radius) * (edge * edge / 8 + c * (a * a * a + b * b * b) / 3)};
}

/// Memory lengths over contact half-widths, and a period that isolates the contact.
constexpr double kMemories[] = {0, 0.01, 0.3, 1, 1.7, 5};
double isolated(double a, double c) {
  return 2 * a + 40 * c + a;
}

class Represented : public testing::TestWithParam<Scheme> {};

TEST_P(Represented, WedgeIsExactWhateverTheGrid) {
  const double t = 1e-3, d = 2e-6, a = d / t;
  for (const double ratio : kMemories)
    for (const std::size_t nodes : {64UL, 1000UL}) {
      const double c = ratio * a;
      const PreparedProfile line = prepareProfile(wedgeLine(isolated(a, c), nodes, t), GetParam());
      const SteadyResult result = slideAtDepth(line, withRelaxationLength(c), d);
      const Forces exact = wedgeForces(t, d, c);
      EXPECT_LT(relativeError(result.normalForce, exact.normal), 1e-9) << ratio;
      if (c > 0) {
        EXPECT_LT(relativeError(result.tangentialForce, exact.tangential), 1e-9) << ratio;
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Schemes, Represented, testing::Values(Scheme::Linear, Scheme::Cubic));

TEST(ClosedForms, ParabolaIsExactForCubicWhateverTheGrid) {
  const double radius = 0.1, d = 2e-6, a = std::sqrt(2 * radius * d);
  for (const double ratio : kMemories)
    for (const std::size_t nodes : {64UL, 1000UL}) {
      const double c = ratio * a;
      const PreparedProfile line =
          prepareProfile(parabolaLine(isolated(a, c), nodes, radius), Scheme::Cubic);
      const SteadyResult result = slideAtDepth(line, withRelaxationLength(c), d);
      const Forces exact = parabolaForces(radius, d, c);
      EXPECT_LT(relativeError(result.normalForce, exact.normal), 1e-9) << ratio;
      if (c > 0) {
        EXPECT_LT(relativeError(result.tangentialForce, exact.tangential), 1e-9) << ratio;
      }
    }
}

TEST(ClosedForms, ParabolaConvergesAtSecondOrderForLinear) {
  const double radius = 0.1, d = 2e-6, a = std::sqrt(2 * radius * d), c = a;
  const Forces exact = parabolaForces(radius, d, c);
  const auto error = [&](std::size_t nodes) {
    const Line line = parabolaLine(isolated(a, c), nodes, radius);
    const SteadyResult r =
        slideAtDepth(prepareProfile(line, Scheme::Linear), withRelaxationLength(c), d);
    return std::max(relativeError(r.normalForce, exact.normal),
                    relativeError(r.tangentialForce, exact.tangential));
  };
  EXPECT_LT(error(4000), 1e-3);
  EXPECT_GT(std::log2(error(1000) / error(8000)) / 3, 1.8);
}

TEST(ClosedForms, NodalShapesApproachTheClosedForms) {
  const double t = 1e-3, d = 2e-6, a = d / t, c = 0.5 * a;
  const Line wedge = wedgeLine(isolated(a, c), 200000, t);
  const SteadyResult w =
      slideAtDepth(prepareProfile(wedge, Scheme::Nodal), withRelaxationLength(c), d);
  EXPECT_LT(relativeError(w.normalForce, wedgeForces(t, d, c).normal), 1e-3);
  EXPECT_LT(relativeError(w.tangentialForce, wedgeForces(t, d, c).tangential), 1e-3);
}

TEST(ClosedForms, ParabolaAtLowVelocityHasFrictionCOverR) {
  const double radius = 0.1, d = 2e-6, a = std::sqrt(2 * radius * d), c = 1e-9 * a;
  const PreparedProfile line = prepareProfile(parabolaLine(4 * a, 64, radius), Scheme::Cubic);
  EXPECT_LT(relativeError(slideAtDepth(line, withRelaxationLength(c), d).mu, c / radius), 1e-8);
}

TEST(ClosedForms, ParabolaAtFixedForceHasItsMaximumWhereTheFormulaSays) {
  const double radius = 0.1, force = 0.01;
  const double a0 = std::cbrt(3 * radius * force / (8 * kModulus));
  const PreparedProfile line = prepareProfile(parabolaLine(80 * a0, 2000, radius), Scheme::Cubic);
  const auto friction = [&](double ratio) {
    return slideAtForce(line, withRelaxationLength(ratio * a0), force).mu * radius / a0;
  };
  EXPECT_NEAR(friction(1.397), 0.4431, 5e-5);
  EXPECT_GT(friction(1.397), friction(1.30));
  EXPECT_GT(friction(1.397), friction(1.50));
}

TEST(ClosedForms, SineInFullContact) {
  const double amplitude = 5e-7, length = 0.01, q = 2 * std::numbers::pi * 4 / length;
  const double c = 0.7 / q, d = 1.01 * amplitude * std::hypot(1, q * c);  // above the mean
  const double exact = c * q * q * amplitude * amplitude / (2 * d);
  const auto error = [&](std::size_t nodes, Scheme scheme) {
    const Line line = sineLine(length, nodes, amplitude, 4);
    return relativeError(
        slideAtDepth(prepareProfile(line, scheme), withRelaxationLength(c), d + amplitude).mu,
        exact);
  };
  EXPECT_LT(error(200, Scheme::Nodal), 1e-12);
  EXPECT_LT(error(2000, Scheme::Linear), 1e-3);
  EXPECT_LT(error(200, Scheme::Cubic), 1e-3);
  EXPECT_GT(std::log2(error(400, Scheme::Linear) / error(1600, Scheme::Linear)) / 2, 1.8);
  EXPECT_GT(std::log2(error(200, Scheme::Cubic) / error(800, Scheme::Cubic)) / 2, 3.5);
}

/// v tau far above the wavelength: mu / (A q) depends on delta / A alone, delta = F_N / 4 eta v.
TEST(ClosedForms, FastSine) {
  const double amplitude = 5e-7, length = 0.01, q = 2 * std::numbers::pi / length;
  const PreparedProfile line = prepareProfile(sineLine(length, 4000, amplitude, 1), Scheme::Cubic);
  const double ratios[] = {0.01, 0.1, 0.5, 1, 2, 3, 5};
  const double table[] = {0.0925, 0.278, 0.548, 0.683, 0.769, 0.753, 0.610};
  const double c = 1e5 * length;
  for (int i = 0; i < 7; ++i) {
    const double force = ratios[i] * amplitude * 4 * kModulus * c;
    const SteadyResult result = slideAtForce(line, withRelaxationLength(c), force);
    EXPECT_EQ(result.status, SteadyStatus::Balanced);
    EXPECT_NEAR(result.mu / (amplitude * q), table[i], 5.1e-4) << ratios[i];
  }
}

/// Eq. (8): complete contact, F_N = 4 G L d about the mean and F_x = 4 L eta v grad^2.
TEST(ClosedForms, FullContactOfARoughLine) {
  const auto error = [](std::int64_t oversampling, Scheme scheme) {
    const Line line = roughLine(500, oversampling);
    const double force = 100, v = 0.01;
    const SteadyResult result =
        slideAtForce(prepareProfile(line, scheme), {kModulus, kTau, v}, force);
    EXPECT_NEAR(result.contactFraction, 1, 1e-12);
    const double exact =
        4 * line.length * kModulus * kTau * v * line.rmsSlope * line.rmsSlope / force;
    return relativeError(result.mu, exact);
  };
  EXPECT_LT(error(1, Scheme::Nodal), 1e-10);
  EXPECT_LT(error(4, Scheme::Cubic), 1e-3);
  EXPECT_GT(std::log2(error(2, Scheme::Cubic) / error(16, Scheme::Cubic)) / 3, 3.5);
  EXPECT_GT(std::log2(error(2, Scheme::Linear) / error(16, Scheme::Linear)) / 3, 1.8);
}

}  // namespace
}  // namespace asperity
