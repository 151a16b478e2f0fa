// More points on the same band-limited line bring friction to one value: under every load and
// velocity that a slider reaches, from lines rough at every scale to smooth ones.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/surface/line_source.h"
#include "tests/stability/invariants.h"

namespace asperity {
namespace {

constexpr std::array<int, 4> kPoints{1, 4, 16, 64};  // an element

/// Relative, of mu from that of many more points.
std::array<double, 4> errorsOf(Scene scene, Scheme scheme) {
  const SlidingConditions conditions{scene.elastomer.shearModulus, scene.elastomer.relaxationTime,
                                     scene.sliding.velocity};
  const auto muAt = [&](int points, Scheme which) {
    return slideAtLoad(prepareProfile(LineSource(scene, points).make(0), which), conditions,
                       scene.load)
        .mu;
  };
  const double exact = muAt(256, Scheme::Cubic);
  std::array<double, 4> errors{};
  for (std::size_t i = 0; i < errors.size(); ++i)
    errors[i] = std::abs(muAt(kPoints[i], scheme) / exact - 1);
  return errors;
}

TEST(Refinement, Converges) {
  fmt::print("{:<5} {:>8} {:>8} {:<7} {:>8} {:>8} {:>8} {:>8}\n", "H", "v", "Fbar", "scheme", "x1",
             "x4", "x16", "x64");
  for (const double hurst : {0.0, 0.7, 1.0})
    for (const double velocity : {1e-6, 1e-3, 1.0, 1e3})
      for (const double bar : {1e-6, 1e-3, 1.0, 1e3})
        for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
          Scene scene;
          scene.surface.elements = 100;
          scene.surface.hurst = hurst;
          scene.sliding.velocity = velocity;
          scene.load.normalForce =
              bar * scene.elastomer.shearModulus * scene.surface.rmsHeight * scene.surface.length;
          const auto errors = errorsOf(scene, scheme);
          SCOPED_TRACE(fmt::format("H = {}, v = {}, Fbar = {}", hurst, velocity, bar));
          fmt::print("{:<5} {:>8.0e} {:>8.0e} {:<7} {:>8.1e} {:>8.1e} {:>8.1e} {:>8.1e}\n", hurst,
                     velocity, bar, scheme == Scheme::Linear ? "linear" : "cubic", errors[0],
                     errors[1], errors[2], errors[3]);
          // Corners of straight segments hide how slowly they go where next to nothing touches.
          EXPECT_LT(errors[3], 0.1 * errors[0]);
          if (scheme == Scheme::Linear) continue;
          EXPECT_TRUE(errors[0] > errors[1] && errors[1] > errors[2] && errors[2] > errors[3]);
          EXPECT_LT(errors[0], 0.1);
          EXPECT_LT(errors[2], 2e-4);
          EXPECT_LT(errors[3], 2e-5);
        }
}

}  // namespace
}  // namespace asperity
