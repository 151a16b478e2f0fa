#include "core/run/steady_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/input_error.h"

namespace asperity {
namespace {

std::shared_ptr<const Scene> steadyScene() {
  auto scene = std::make_shared<Scene>();
  scene->surface.elements = 200;
  scene->load.normalForce = 0.02;
  return scene;
}

/// Where contact lies between the points, what they bear is not the load.
TEST(SteadyFrames, PressuresOfPointsCountOnlyWhereTheyBearTheLoad) {
  SteadyShape shape;
  shape.nodes.pressure = {0, 3, 0, 1};  // with points a millimetre apart: 4 mN
  EXPECT_EQ(greatestPressure(shape, 1e-3, 39e-3), 3);
  EXPECT_TRUE(std::isnan(greatestPressure(shape, 1e-3, 41e-3)));
  EXPECT_EQ(greatestPressure(shape, 1e-3, 0), 3);
}

TEST(SteadyFrames, FramesDivideOnePeriod) {
  const SteadyFrames frames(steadyScene());
  const Frame first = frames.frame(0, 8, 25), third = frames.frame(2, 8, 25);
  const std::size_t n = first.lineHeight.size(), shift = n / 4;
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(third.lineHeight[(i + shift) % n], first.lineHeight[i]);
    EXPECT_EQ(third.pressure[(i + shift) % n], first.pressure[i]);
  }
  EXPECT_NEAR(third.distance, 0.25 * 0.02, 1e-15);
  EXPECT_NEAR(third.time, 0.005, 1e-15);  // at 1 m/s
  EXPECT_NEAR(third.timeScale, 0.02 / 8 * 25, 1e-15);
}

TEST(SteadyFrames, NothingReachesThroughTheLineAndPressureIsInContactOnly) {
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
    auto scene = std::make_shared<Scene>(*steadyScene());
    scene->accuracy.scheme = scheme;
    const Frame frame = SteadyFrames(scene).frame(0, 1, 25);
    for (std::size_t i = 0; i < frame.lineHeight.size(); ++i) {
      EXPECT_LE(frame.surfaceHeight[i], 0);
      EXPECT_GE(frame.lineHeight[i] - frame.surfaceHeight[i], -1e-19);
      EXPECT_GE(frame.pressure[i], 0);
      if (frame.pressure[i] > 0) {
        EXPECT_NEAR(frame.lineHeight[i], frame.surfaceHeight[i], 1e-18);
      }
    }
    EXPECT_GT(*std::max_element(frame.pressure.begin(), frame.pressure.end()), 0);
  }
}

/// Of Kelvin elements p = 4G (|u| + tau v z') with what the frame shows at each point in contact,
/// of every line: also under a corner and between straight segments.
TEST(SteadyFrames, PressureIsThatOfTheDepthAndTheSlopeShown) {
  for (const SurfaceKind kind :
       {SurfaceKind::SelfAffine, SurfaceKind::Wedge, SurfaceKind::Parabola})
    for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
      auto scene = std::make_shared<Scene>(*steadyScene());
      scene->surface.kind = kind;
      scene->accuracy.scheme = scheme;
      const Frame frame = SteadyFrames(scene, {true, false, true}).frame(3, 8, 25);
      const double g = scene->elastomer.shearModulus, tau = scene->elastomer.relaxationTime;
      const double largest = *std::max_element(frame.pressure.begin(), frame.pressure.end());
      int touching = 0;
      for (std::size_t i = 0; i < frame.pressure.size(); ++i) {
        if (!(frame.pressure[i] > 0)) continue;
        ++touching;
        const double rate = tau * scene->sliding.velocity * frame.lineSlope[i];
        EXPECT_NEAR(frame.pressure[i], 4 * g * (rate - frame.surfaceHeight[i]), 1e-9 * largest);
        EXPECT_NEAR(frame.power[i], 4 * g / tau * rate * rate, 1e-6 * largest);
      }
      EXPECT_GT(touching, 10) << static_cast<int>(kind);
    }
}

/// Power is dissipated in the elastomer and, in scenes that have local friction, in the interface.
TEST(SteadyFrames, PowerIsThatOfTheWholeFriction) {
  for (const auto& [coefficient, shear] : {std::pair{0.0, 0.0}, {0.3, 0.0}, {0.0, 2.0}}) {
    auto scene = std::make_shared<Scene>(*steadyScene());
    scene->interface.frictionCoefficient = coefficient;
    scene->interface.shearStress = shear;
    const Frame frame = SteadyFrames(scene, {false, false, true}).frame(0, 1, 25);
    double sum = 0;
    for (const double power : frame.power) sum += power * frame.spacing;
    const double wanted =
        (frame.state.mu + frame.state.muInterface) * frame.state.normalForce * frame.velocity;
    EXPECT_EQ(frame.state.muInterface > 0, coefficient + shear > 0);
    EXPECT_NEAR(sum / wanted, 1, 0.02) << coefficient << " " << shear;
  }
}

TEST(SteadyFrames, ANarrowViewIsMovedAsFinelyAsAWideOne) {
  const double seen = 1e-2 * 0.02;
  const Frame wide = SteadyFrames(steadyScene()).frame(0, 1, 25);
  const SteadyFrames close(steadyScene(), {}, seen);
  EXPECT_LT(close.frame(0, 1, 25).spacing, 1e-3 * seen);
  EXPECT_LT(wide.spacing, 1e-3 * wide.length);
  // The same line at the same places.
  const Frame fine = close.frame(0, 1, 25);
  constexpr std::size_t kElements = 200;
  for (std::size_t i = 0; i < kElements; ++i)
    EXPECT_NEAR(fine.lineHeight[i * (fine.lineHeight.size() / kElements)],
                wide.lineHeight[i * (wide.lineHeight.size() / kElements)], 1e-4 * wide.rmsHeight);
}

TEST(SteadyFrames, AtRestNothingMoves) {
  auto scene = std::make_shared<Scene>(*steadyScene());
  scene->sliding.velocity = 0;
  const SteadyFrames frames(scene);
  EXPECT_EQ(frames.frame(3, 8, 25).time, 0);
  EXPECT_EQ(frames.result().mu, 0);
}

TEST(SteadyFrames, ASceneThatCannotRunIsRefused) {
  auto scene = std::make_shared<Scene>(*steadyScene());
  scene->surface.kind = SurfaceKind::Profile;
  scene->surface.file = "none.csv";
  EXPECT_THROW(SteadyFrames{scene}, InputError);
}

}  // namespace
}  // namespace asperity
