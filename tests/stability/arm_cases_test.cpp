// Hard cases of elements with arms, as a table: what was tried, which invariant came nearest to its
// limit, and how far mu is from the same computation in wider numbers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>

#include "core/contact/arms/arm_balance.h"
#include "core/contact/steady_solver.h"
#include "core/surface/line_source.h"
#include "tests/stability/invariants.h"
#include "tests/stability/reference_arms.h"

namespace asperity {
namespace {

struct ArmCase {
  std::string name, why;
  std::vector<Arm> arms;
  double velocity = 1, force = 0.0034, equilibrium = 1e7, viscosity = 0;
  std::int64_t elements = 200;
};

std::vector<ArmCase> armCases() {
  const std::vector<Arm> one{{1e7, 1e-3}}, wide{{1e6, 1e2}, {4e6, 1e-3}, {2e7, 1e-10}};
  return {
      {"v = 1e-12", "everything relaxes within 1e-10 of an element", one, 1e-12},
      {"v = 1e9", "nothing relaxes within 1e7 periods", one, 1e9},
      {"tau from 1e-10 to 100 s", "closes only after 5000 periods by itself", wide, 1},
      {"tau = 1e-149", "c below 1e-150 of an element", {{1e7, 1e-149}}, 1e-9},
      {"tau = 1e12 and 1e-149", "times 1e161 apart", {{1e7, 1e12}, {1e7, 1e-149}}},
      {"tau = 1e12 and 1e-297", "1e309 apart: one never acts", {{1e7, 1e12}, {1e7, 1e-297}}},
      {"tau = 1e12", "never relaxes", {{1e7, 1e12}}, 1},
      {"two times 1e-12 apart",
       "poles next to each other",
       {{1e7, 1e-3 * (1 + 1e-12)}, {1e7, 1e-3}}},
      {"an arm of 1e-6 of G", "hardly there", {{10, 1e-3}}},
      {"arms 1e6 times G", "depths far above strains", {{1e9, 1e-3}, {3e8, 1e-6}}, 1, 1e-3, 1e3},
      {"G = 1e-3 Pa", "digits lost by rounding alone", {{1e7, 1e-3}}, 1, 1e-9, 1e-3},
      {"with a dashpot of 1e12 Pa s", "it does not move in a period", wide, 1, 0.0034, 1e7, 1e12},
      {"with a dashpot of 1e-12 Pa s", "hardly there", wide, 1, 0.0034, 1e7, 1e-12},
      {"F_N = 1e-9 N", "contact within one element", wide, 1, 1e-9},
      {"F_N = 1e12 N", "d far above the heights", wide, 1, 1e12},
      {"F_N = 1e12 N, v = 1e3", "and friction of 1e-20 of it", wide, 1e3, 1e12},
      {"N = 3", "one mode", wide, 1, 0.0034, 1e7, 0, 3},
      {"N = 47, light and fast", "contact far below an element", wide, 1e3, 1e-6, 1e7, 0, 47},
  };
}

/// An ulp of a strain is this much of the pressure, and friction below the least is rounding.
constexpr double kRelative = 1e-11, kPerStiffness = 1e-15, kMinMu = 1e-80;

Scene sceneOf(const ArmCase& row, Scheme scheme) {
  Scene scene;
  scene.surface.elements = row.elements;
  scene.elastomer.rheology = Rheology::Prony;
  scene.elastomer.equilibriumModulus = row.equilibrium;
  scene.elastomer.viscosity = row.viscosity;
  scene.elastomer.arms = row.arms;
  scene.load.normalForce = row.force;
  scene.accuracy.scheme = scheme;
  return scene;
}

/// Times so short that nothing can slide in them, down to the smallest number: such an arm is as if
/// it were not there.
TEST(ArmCases, ArmsOfNoTimeAreAsGood) {
  for (const double shortest : {1e-151, 1e-297, 1e-310, 5e-324}) {
    SCOPED_TRACE(shortest);
    for (const std::vector<Arm>& arms :
         {std::vector<Arm>{{1e7, shortest}}, std::vector<Arm>{{1e7, 1e-3}, {1e15, shortest}},
          std::vector<Arm>{{1e7, 1e12}, {3e6, 2 * shortest}, {1e15, shortest}}}) {
      Scene scene = sceneOf({"", "", arms}, Scheme::Cubic);
      const PreparedProfile line = prepareProfile(LineSource(scene, 2).make(0), Scheme::Cubic);
      const SteadyResult with = SteadySolver(scene).at(line, 1).result;
      std::erase_if(scene.elastomer.arms,
                    [](const Arm& arm) { return arm.relaxationTime < 1e-150; });
      const SteadyResult without = SteadySolver(scene).at(line, 1).result;
      EXPECT_FALSE(isRefused(with)) << with.residual;
      EXPECT_EQ(with.mu, without.mu);
      EXPECT_EQ(with.indentation, without.indentation);
    }
  }
}

/// A dashpot that yields in no time beside arms, likewise.
TEST(ArmCases, ADashpotOfNoTimeIsAsGood) {
  for (const double viscosity : {1e-144, 1e-300, 5e-324}) {
    Scene scene = sceneOf({"", "", {{1e7, 1e-3}}}, Scheme::Cubic);
    const PreparedProfile line = prepareProfile(LineSource(scene, 2).make(0), Scheme::Cubic);
    const SteadyResult without = SteadySolver(scene).at(line, 1).result;
    scene.elastomer.viscosity = viscosity;
    const SteadyResult with = SteadySolver(scene).at(line, 1).result;
    EXPECT_FALSE(isRefused(with)) << viscosity << ": " << with.residual;
    EXPECT_EQ(with.mu, without.mu) << viscosity;
  }
}

/// A search that finds nothing but what is no number ends with an answer that is not met and can be
/// drawn: a strain for every arm.
TEST(ArmCases, ASearchAmongNoNumbersEnds) {
  ::fedisableexcept(FE_INVALID | FE_DIVBYZERO);  // what the other tests end at is wanted here
  const Scene scene = sceneOf({"", "", {{1e7, 1e-3}, {1e6, 1}}}, Scheme::Cubic);
  const PreparedProfile line = prepareProfile(LineSource(scene, 2).make(0), Scheme::Cubic);
  const ElementLaw law = SteadySolver(scene).law();
  RetardationModes modes = retardationModes(law);
  for (double& fluidity : modes.fluidity) fluidity = std::numeric_limits<double>::quiet_NaN();
  ArmTables tables(law, modes);
  for (const LoadKind kind : {LoadKind::Force, LoadKind::Indentation}) {
    Load load;
    load.kind = kind;
    const ArmState found = slideWithArms(line, tables, load, 1);
    EXPECT_TRUE(isRefused(found.result));
    EXPECT_FALSE(found.balance.isMet());
    EXPECT_EQ(found.balance.strain.size(), 2U);
    const ArmShape shape = armShapeAt(line, tables, 1, found.balance);
    EXPECT_EQ(shape.nodes.depth.size(), line.segments());
  }
  std::feclearexcept(FE_ALL_EXCEPT);
  ::feenableexcept(FE_INVALID | FE_DIVBYZERO);
}

/// What a result says of itself, as that of one relaxation time as long as its longest.
std::vector<Finding> findingsOf(const Line& line, const Scene& scene, const ElementLaw& law,
                                double velocity, const SteadyResult& result, double rounding) {
  const double longest = std::max(law.relaxationTime, law.arms.front().relaxationTime);
  std::vector<Finding> findings = resultFindings(
      {line, scene.accuracy.scheme, {law.equilibriumModulus, longest, velocity}, scene.load},
      result);
  for (Finding& finding : findings)
    if (finding.allowed > 0) finding.allowed += rounding;
  return findings;
}

TEST(ArmCases, Table) {
  fmt::print("{:<30} {:<7} {:>10} {:>6} {:<24} {:>8} {:>8} {:>8} {}\n", "case", "scheme", "mu",
             "passes", "invariant nearest", "value", "error", "allowed", "what is hard");
  for (const ArmCase& row : armCases())
    for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
      SCOPED_TRACE(row.name);
      const Scene scene = sceneOf(row, scheme);
      const SteadySolver sliding(scene);
      const Line line = LineSource(scene, 2).make(0);
      const SteadyState state = sliding.at(prepareProfile(line, scheme), row.velocity);
      const SteadyResult& result = state.result;
      const ReferenceResult reference =
          referenceWithArms(line, scheme, sliding.law(), row.velocity, scene.load,
                            result.indentation, state.arms.strain);
      double rounding = 0;
      for (const Arm& arm : row.arms) rounding += kPerStiffness * arm.modulus / row.equilibrium;
      const Wide apart = std::abs(result.mu - reference.mu);
      const double error = static_cast<double>(apart / reference.mu);
      const std::vector<Finding> findings =
          findingsOf(line, scene, sliding.law(), row.velocity, result, rounding);
      const Finding worst = worstOf(findings);
      fmt::print("{:<30} {:<7} {:>10.4g} {:>6} {:<24} {:>8.1e} {:>8.1e} {:>8.1e} {}\n", row.name,
                 scheme == Scheme::Linear ? "linear" : "cubic", result.mu, result.passes,
                 worst.invariant, worst.value, error, kRelative + rounding, row.why);
      EXPECT_FALSE(isRefused(result)) << result.residual;
      EXPECT_LE(reference.periodicityError, 1e-16L) << "of the reference itself";
      EXPECT_TRUE(error <= kRelative + rounding || apart <= kMinMu)
          << result.mu << " is not " << reference.mu;
      for (const Finding& finding : findings)
        EXPECT_TRUE(finding.holds()) << finding.invariant << ": " << finding.value;
    }
}

}  // namespace
}  // namespace asperity
