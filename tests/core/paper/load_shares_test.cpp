// Who carries the load, against closed forms: a sine in complete contact, and its limits.
#include "core/paper/load_shares.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/core/small_scene.h"

namespace asperity {
namespace {

LoadShares sharesAt(const Scene& scene, double force, std::vector<double> velocities,
                    std::int64_t lines = 1, int threads = 1) {
  StateOptions options;
  options.threads = threads;
  return {scene, {atForce(force, std::move(velocities))}, lines, options};
}

/// p = 4 G (d - z) + 4 eta v z' everywhere: the springs carry all, for the mean of z' is 0, and the
/// trailing halves 1/2 - 2 A n v tau / (d L).
TEST(LoadShares, OfASineInCompleteContact) {
  Scene scene;
  scene.surface.kind = SurfaceKind::Sine;
  scene.surface.elements = 4000;
  scene.surface.waves = 4;
  const double depth = 10 * scene.surface.amplitude;
  const double force = 4 * scene.elastomer.shearModulus * scene.surface.length * depth;
  const LoadShares shares = sharesAt(scene, force, {1e-6, 0.1, 0.5});
  const std::vector<double>& velocities = shares.loadCase(0).velocities;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    const double slid = velocities[i] * scene.elastomer.relaxationTime;
    const double expected =
        0.5 - 2 * scene.surface.amplitude * 4 * slid / (depth * scene.surface.length);
    EXPECT_NEAR(shares.trailing(0, i), expected, 1e-3);
    EXPECT_NEAR(shares.elastic(0, i), 1, 1e-6);
  }
}

/// Contacts shorter than the distance of the nodes do not count for more than they carry.
/// Slow sliding is elastic and has two sides alike; fast sliding is viscous and one-sided, and on
/// the last smooth summits mu is 2/sqrt(3) times the slope in contact.
TEST(LoadShares, OfARoughLineInItsLimits) {
  const Scene scene = sceneOfSize(2000, 1, 6);
  const LoadShares shares = sharesAt(scene, 0.0034, {1e-5, 1.0, 1e5}, 6);
  EXPECT_NEAR(shares.elastic(0, 0), 1, 0.02) << "summed over nodes";
  EXPECT_NEAR(shares.trailing(0, 0), 0.5, 0.05);
  EXPECT_LT(shares.elastic(0, 1), 0.2);
  EXPECT_LT(shares.trailing(0, 1), 0.02);
  EXPECT_LT(shares.elastic(0, 2), 0.01);
  EXPECT_NEAR(shares.frictionOverSlope(0, 2), 2 / std::numbers::sqrt3, 1e-3);
}

TEST(LoadShares, AreTheSameForAnyThreadsAndLeaveGroupsOut) {
  const Scene scene = sceneOfSize(500, 1, 5);
  const LoadShares one = sharesAt(scene, 0.0034, {0.1}, 5, 1);
  const LoadShares three = sharesAt(scene, 0.0034, {0.1}, 5, 3);
  EXPECT_EQ(one.trailing(0, 0), three.trailing(0, 0));
  EXPECT_EQ(one.groups(), 5);
  EXPECT_NE(one.elastic(0, 0, 2), one.elastic(0, 0));
}

}  // namespace
}  // namespace asperity
