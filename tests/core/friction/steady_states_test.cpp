// Many states on common lines: each is the point of its own curve, and what the model says of
// scaling holds.
#include "core/friction/steady_states.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/material/temperature_shift.h"
#include "core/scene/parameters.h"
#include "tests/core/elastomers.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

Scene sceneOfStates() {
  return sceneOfSize(300, 5, 6, 0.02);
}

void set(Scene& scene, const char* key, double value) {
  setValue(*findParameter(key), scene, value);
}

void expectSame(const CurvePoint& a, const CurvePoint& b, double tolerance,
                const std::string& where) {
  constexpr double kNoFriction = 1e-25;  // what rounding leaves of an elastic solid's
  const auto expectNearBy = [&](double x, double y, double size, const char* what) {
    if (std::isnan(y))
      EXPECT_TRUE(std::isnan(x)) << what << ", " << where;
    else
      EXPECT_NEAR(x, y, tolerance * std::abs(size) + kNoFriction) << what << ", " << where;
  };
  const auto expectNear = [&](double x, double y, const char* what) {
    expectNearBy(x, y, y, what);
  };
  expectNear(a.mu, b.mu, "mu");
  expectNearBy(a.muStandardError, b.muStandardError, b.mu, "error");  // differences of mu
  expectNear(a.muLaw, b.muLaw, "law");
  expectNearBy(a.contactFraction, b.contactFraction, 1, "contact");  // edges, in line lengths
  expectNear(a.rmsSlopeContact, b.rmsSlopeContact, "slope");
  expectNear(a.indentation, b.indentation, "indentation");
  expectNear(a.normalizedMu, b.normalizedMu, "normalized");
  expectNear(a.dimensionlessForce, b.dimensionlessForce, "force");
  expectNear(a.muInterface, b.muInterface, "interface");
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.realizations, b.realizations);
}

/// States that differ in every key that may share work, and in keys that may not.
std::vector<Scene> statesOf(const Scene& base) {
  const bool hasArms = base.elastomer.rheology == Rheology::Prony ||
                       base.elastomer.rheology == Rheology::StandardSolid;
  std::vector<Scene> states;
  for (const double velocity : {1e-3, 0.3, 0.02})
    for (const double force : {0.0034, 1.0, 2e-4}) {
      Scene scene = base;
      scene.sliding.velocity = velocity;
      scene.load.normalForce = force;
      states.push_back(scene);
      set(scene, "surface.rms_height", 2.3e-6);
      states.push_back(scene);
      set(scene, hasArms ? "elastomer.equilibrium_modulus" : "elastomer.shear_modulus", 3.7e6);
      states.push_back(scene);
      set(scene, "surface.hurst", 0.4);
      states.push_back(scene);
      if (base.elastomer.rheology == Rheology::Elastic) continue;
      set(scene, "elastomer.temperature", 320);
      states.push_back(scene);
    }
  return states;
}

/// The friction found may differ by what the force balance leaves, which is 1e-12 and smaller.
TEST(SteadyStates, EachIsThePointOfItsOwnCurve) {
  for (const auto& [name, elastomer] : allElastomers()) {
    Scene base = sceneOfStates();
    base.elastomer = elastomer;
    base.interface.frictionCoefficient = 0.1;
    const std::vector<Scene> states = statesOf(base);
    const SteadyStates found = slideStates(states);
    ASSERT_EQ(found.points.size(), states.size());
    for (std::size_t i = 0; i < states.size(); ++i)
      expectSame(found.points[i], pointOfCurve(states[i]), 1e-12, name + " " + std::to_string(i));
  }
}

TEST(SteadyStates, AtAnIndentationToo) {
  Scene base = sceneOfStates();
  base.load.kind = LoadKind::Indentation;
  std::vector<Scene> states;
  for (const double depth : {1e-7, 1e-6, 3e-6}) {
    base.load.depth = depth;
    states.push_back(base);
    Scene higher = base;
    set(higher, "surface.rms_height", 1e-6);
    states.push_back(higher);
  }
  const SteadyStates found = slideStates(states);
  for (std::size_t i = 0; i < states.size(); ++i)
    expectSame(found.points[i], pointOfCurve(states[i]), 1e-12, std::to_string(i));
}

/// Friction over v and tau depends on v tau alone: n + n - 1 states of n n.
TEST(SteadyStates, VelocityAndRelaxationTimeAreOneParameter) {
  std::vector<Scene> states;
  const int n = 9;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      states.push_back(sceneOfStates());
      states.back().sliding.velocity = 1e-3 * std::pow(10, i / 4.0);
      states.back().elastomer.relaxationTime = 1e-4 * std::pow(10, j / 4.0);
    }
  const SteadyStates found = slideStates(states);
  EXPECT_EQ(found.computed, 2U * n - 1);
  for (int j = 1; j < n; ++j)
    for (int i = 0; i + 1 < n; ++i)
      EXPECT_EQ(found.points[static_cast<std::size_t>(j * n + i)].mu,
                found.points[static_cast<std::size_t>((j - 1) * n + i + 1)].mu);
}

/// Over F_N and G friction depends on F_N / G alone.
TEST(SteadyStates, ForceAndModulusAreOneParameter) {
  std::vector<Scene> states;
  const int n = 9;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      states.push_back(sceneOfStates());
      states.back().load.normalForce = 1e-3 * std::pow(10, i / 4.0);
      states.back().elastomer.shearModulus = 1e6 * std::pow(10, j / 4.0);
    }
  const SteadyStates found = slideStates(states);
  EXPECT_EQ(found.computed, 2U * n - 1);
}

/// A real rubber's moduli scale together, its times with temperature.
TEST(SteadyStates, ArmsShareWhereTheyScaleTogether) {
  Scene base = sceneOfStates();
  base.elastomer = treadCompound();
  std::vector<Scene> states{base, base, base};
  states[1].elastomer.equilibriumModulus *= 2;
  for (Arm& arm : states[1].elastomer.arms) arm.modulus *= 2;
  states[1].elastomer.viscosity *= 2;
  states[1].load.normalForce *= 2;
  states[2].elastomer.temperature += 7;
  states[2].sliding.velocity *= shiftFactor(base.elastomer.shift, base.elastomer.temperature) /
                                shiftFactor(base.elastomer.shift, base.elastomer.temperature + 7);
  const SteadyStates found = slideStates(states);
  EXPECT_EQ(found.computed, 1U);
  EXPECT_EQ(found.points[0].mu, found.points[1].mu);
  EXPECT_EQ(found.points[0].mu, found.points[2].mu);
}

TEST(SteadyStates, AnyNumberOfThreadsGivesTheSameBytes) {
  const std::vector<Scene> states = statesOf(sceneOfStates());
  std::string first;
  for (const int threads : {1, 2, 5}) {
    StateOptions options;
    options.threads = threads;
    const std::string text = curveCsv(slideStates(states, options).points);
    if (first.empty()) first = text;
    EXPECT_EQ(text, first);
  }
}

TEST(SteadyStates, KeepsTheFrictionOfEachLine) {
  const std::vector<Scene> states{sceneOfStates()};
  StateOptions options;
  options.keepsLines = true;
  const SteadyStates found = slideStates(states, options);
  ASSERT_EQ(found.muOfLines.front().size(), 6U);
  double sum = 0;
  for (const double mu : found.muOfLines.front()) sum += mu;
  EXPECT_NEAR(sum / 6 / found.points.front().mu, 1, 1e-14);
}

TEST(SteadyStates, StopsWithoutAnAnswer) {
  std::stop_source source;
  source.request_stop();
  StateOptions options;
  options.stop = source.get_token();
  const std::vector<Scene> states{sceneOfStates()};
  EXPECT_FALSE(slideStates(states, options).isComplete);
}

}  // namespace
}  // namespace asperity
