// Hard cases of elements with arms, as a table: what was tried and what came nearest to its limit.
// There is no second computation to compare with: power and both ways to the force say how many
// digits are left, and complete contact has its closed form.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/contact/scene_sliding.h"
#include "core/surface/line_source.h"
#include "tests/stability/invariants.h"

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
      {"tau = 1e-300", "1 / c beyond numbers", {{1e7, 1e-300}}, 1e-9},
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

TEST(ArmCases, Table) {
  fmt::print("{:<30} {:<7} {:>10} {:>6} {:>8} {:<24} {:>8} {}\n", "case", "scheme", "mu", "passes",
             "closure", "invariant nearest", "value", "what is hard");
  for (const ArmCase& row : armCases())
    for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
      SCOPED_TRACE(row.name);
      Scene scene;
      scene.surface.elements = row.elements;
      scene.elastomer.rheology = Rheology::Prony;
      scene.elastomer.equilibriumModulus = row.equilibrium;
      scene.elastomer.viscosity = row.viscosity;
      scene.elastomer.arms = row.arms;
      scene.load.normalForce = row.force;
      scene.accuracy.scheme = scheme;
      const SceneSliding sliding(scene);
      Situation situation{LineSource(scene, 2).make(0), scheme, {}, scene.load};
      const ElementLaw& law = sliding.law();
      situation.conditions = {law.equilibriumModulus,
                              std::max(law.relaxationTime, law.arms.front().relaxationTime),
                              row.velocity};
      const SteadyResult result =
          sliding.at(prepareTravel(situation.line, scheme), row.velocity).result;
      double stiffness = 0;
      for (const Arm& arm : row.arms) stiffness += arm.modulus / row.equilibrium;
      std::vector<Finding> findings = resultFindings(situation, result);
      // An ulp of a strain is this much pressure.
      for (Finding& finding : findings)
        if (finding.allowed > 0) finding.allowed += 1e-15 * stiffness;
      const Finding worst = worstOf(findings);
      fmt::print("{:<30} {:<7} {:>10.4g} {:>6} {:>8.1e} {:<24} {:>8.1e} {}\n", row.name,
                 scheme == Scheme::Linear ? "linear" : "cubic", result.mu, result.passes,
                 result.closure, worst.invariant, worst.value, row.why);
      EXPECT_FALSE(isRefused(result)) << result.residual;
      for (const Finding& finding : findings)
        EXPECT_TRUE(finding.holds()) << finding.invariant << ": " << finding.value;
    }
}

}  // namespace
}  // namespace asperity
