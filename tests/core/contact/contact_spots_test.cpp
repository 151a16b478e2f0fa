// The number of separate contact spots: of shapes whose number is known, by every way to a
// steady state, and on rough lines against the nodes that carry load.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/contact/steady_solver.h"
#include "core/surface/line_source.h"
#include "tests/core/contact/instruction_sets.h"
#include "tests/core/elastomers.h"

namespace asperity {
namespace {

class ContactSpots : public EachInstructionSet {};

constexpr double kVelocities[] = {1e-6, 1e-4, 1e-2, 1, 100};

/// By sweeps with vector kernels, and one state at a time by the plain passes.
struct BothWays {
  std::vector<SteadyResult> swept, plain;
  std::vector<std::size_t> nodeRuns;  // of nodes that carry load
};

std::size_t runsAround(const std::vector<double>& pressure) {
  const std::size_t n = pressure.size();
  std::size_t ends = 0;
  for (std::size_t i = 0; i < n; ++i)
    ends += pressure[i] > 0 && !(pressure[(i + 1) % n] > 0) ? 1 : 0;
  return std::ranges::all_of(pressure, [](double p) { return p > 0; }) ? 1 : ends;
}

BothWays slide(const Scene& scene) {
  const PreparedProfile line =
      prepareProfile(LineSource(scene, scene.accuracy.scheme == Scheme::Nodal ? 1 : 2).make(0),
                     scene.accuracy.scheme);
  const SteadySolver solver(scene);
  BothWays both;
  both.swept.resize(std::size(kVelocities));
  EXPECT_TRUE(solver.sweep(line, scene.load, kVelocities, both.swept));
  for (const double velocity : kVelocities) {
    const SteadyState state = solver.at(line, velocity);
    both.plain.push_back(state.result);
    both.nodeRuns.push_back(runsAround(solver.shape(line, velocity, state).nodes.pressure));
  }
  return both;
}

std::vector<Scheme> schemesFor(const Elastomer& elastomer) {
  if (elastomer.arms.empty()) return {Scheme::Nodal, Scheme::Linear, Scheme::Cubic};
  return {Scheme::Linear, Scheme::Cubic};
}

/// Every wave of a sine has its own contact until all have grown together, which is one spot.
TEST_P(ContactSpots, EveryWaveOfASineIsOne) {
  for (const auto& [name, elastomer] : allElastomers())
    for (const Scheme scheme : schemesFor(elastomer)) {
      Scene scene;
      scene.surface.kind = SurfaceKind::Sine;
      scene.surface.amplitude = 1e-6;
      scene.surface.waves = 7;
      scene.surface.elements = 700;
      scene.elastomer = elastomer;
      scene.accuracy.scheme = scheme;
      scene.load.normalForce = 1e-3;
      BothWays both = slide(scene);
      for (std::size_t i = 0; i < std::size(kVelocities); ++i) {
        EXPECT_EQ(both.swept[i].contactSpots, 7) << name << ", " << kVelocities[i] << " m/s";
        EXPECT_EQ(both.plain[i].contactSpots, 7) << name << ", " << kVelocities[i] << " m/s";
      }
      scene.load.normalForce = 1e6;
      both = slide(scene);
      EXPECT_EQ(both.swept[0].contactSpots, 1) << name;
      EXPECT_EQ(both.plain[0].contactSpots, 1) << name;
      EXPECT_EQ(both.swept[0].contactFraction, 1) << name;
    }
}

/// On rough lines both ways find the same number; the elements of the paper touch at nodes alone,
/// elsewhere contacts may lie between two nodes.
TEST_P(ContactSpots, RoughLinesHaveAsManyByEveryWay) {
  for (const auto& [name, elastomer] : allElastomers())
    for (const Scheme scheme : schemesFor(elastomer))
      for (const double force : {1e-3, 0.1, 3.0}) {
        Scene scene;
        scene.surface.elements = 600;
        scene.elastomer = elastomer;
        scene.accuracy.scheme = scheme;
        scene.load.normalForce = force;
        const BothWays both = slide(scene);
        for (std::size_t i = 0; i < std::size(kVelocities); ++i) {
          SCOPED_TRACE(testing::Message() << name << ", scheme " << static_cast<int>(scheme) << ", "
                                          << force << " N, " << kVelocities[i] << " m/s");
          // An element on the edge of contact counts by its share of the load.
          if (both.plain[i].marginalShare < 1) continue;
          EXPECT_EQ(both.swept[i].contactSpots, both.plain[i].contactSpots);
          if (scheme == Scheme::Nodal) {
            EXPECT_EQ(both.plain[i].contactSpots, static_cast<double>(both.nodeRuns[i]));
          } else {
            EXPECT_GE(both.plain[i].contactSpots, static_cast<double>(both.nodeRuns[i]));
            EXPECT_LE(both.plain[i].contactSpots, 2.0 * static_cast<double>(both.nodeRuns[i]) + 2);
          }
        }
      }
}

ASPERITY_ON_EACH_INSTRUCTION_SET(ContactSpots);

}  // namespace
}  // namespace asperity
