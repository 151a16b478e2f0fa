// The pass for arms in vectors against the plain one, pass by pass and in balances, and against a
// march in time that shares no code with either.
#include "core/contact/arms/arm_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/contact/arms/arm_balance.h"
#include "core/contact/march/time_march.h"
#include "core/contact/steady_solver.h"
#include "tests/core/contact/instruction_sets.h"
#include "tests/core/contact/lines.h"
#include "tests/core/elastomers.h"

namespace asperity {
namespace {

class ArmKernel : public EachInstructionSet {};

/// Arms from 10 s down to 1e-8 s, moduli that rise a hundredfold and not evenly.
ElementLaw lawWith(int arms, double viscosity = 0) {
  std::vector<Arm> list;
  for (int i = 0; i < arms; ++i) {
    const double share = arms > 1 ? static_cast<double>(i) / (arms - 1) : 0.5;
    list.push_back({1e6 * (1 + i % 3) * std::pow(100, share), 10 * std::pow(10, -9 * share)});
  }
  return elementLaw(prony(1e6, list, viscosity));
}

void expectSame(const PassSums& sums, const PassSums& plain, double depth, double length) {
  EXPECT_NEAR(sums.depth, plain.depth, 1e-10 * plain.depth);
  EXPECT_NEAR(sums.pressure, plain.pressure, 1e-10 * plain.depth);
  // The work comes from terms as large as what the springs take up.
  EXPECT_NEAR(sums.work, plain.work, 1e-10 * std::abs(plain.work) + 1e-14 * depth * depth);
  EXPECT_NEAR(sums.dissipation, plain.dissipation, 1e-11 * plain.dissipation);
  EXPECT_NEAR(sums.contactLength, plain.contactLength, 1e-11 * length);
  EXPECT_NEAR(sums.slopeSquared, plain.slopeSquared, 1e-11 * plain.slopeSquared);
  EXPECT_EQ(sums.gaps, plain.gaps);
}

/// One pass from strains that are by a tenth off those of steady sliding: all that both find.
void expectPlain(const PreparedProfile& line, ArmTables& tables, double velocity, double depth) {
  SCOPED_TRACE(testing::Message() << line.segments() << " segments, " << tables.law().arms.size()
                                  << " arms, " << velocity << " m/s, " << depth << " m deep");
  const ArmBalance balance = ArmSolver(line, tables, velocity).atDepth(depth);
  ASSERT_TRUE(balance.isMet());
  std::vector<double> strain = balance.strain;
  for (std::size_t i = 0; i < strain.size(); ++i)
    strain[i] *= 1 + 0.1 * std::sin(3.0 * static_cast<double>(i));
  const std::shared_ptr<const ArmTable> table = tables.at(velocity, line);
  ArmPass plain(line, table->coefficients);
  ArmTangent tangent(table->coefficients);
  plain.run(depth, strain, &tangent);
  ArmWorkspace work(table->vectors);
  ArmJacobian jacobian(table->vectors);
  runArmPass(line, table->vectors, depth, strain, Output::Force, work);
  findArmJacobian(table->vectors, work, jacobian);
  EXPECT_NEAR(work.sums.depth, plain.sums().depth, 1e-10 * plain.sums().depth);
  EXPECT_EQ(work.wasComplete(), plain.wasComplete());
  const std::size_t arms = strain.size();
  for (std::size_t i = 0; i < arms; ++i) {
    // As the search scales it: how far the arm is from where its period closes.
    const double change = -std::expm1(-line.length * table->coefficients.inverse[i]);
    EXPECT_NEAR(work.creepChange[i] / change, plain.creepChange()[i] / change, 1e-11 * depth);
    for (std::size_t k = 0; k <= arms; ++k) {
      const double expected = tangent.ofCreepChange(i, k) / change;
      EXPECT_NEAR(jacobian.ofCreepChange(i, k) / change, expected,
                  1e-8 * std::max(1.0, std::abs(expected)));
    }
  }
  for (std::size_t k = 0; k <= arms; ++k)
    EXPECT_NEAR(jacobian.ofDepthIntegral(k), tangent.ofDepthIntegral(k), 1e-8 * line.length);
  plain.runForState(depth, strain);
  runArmPass(line, table->vectors, depth, strain, Output::Everything, work);
  expectSame(work.sums, plain.sums(), depth, line.length);
}

/// Numbers of arms that fill vectors, and some that do not; with and without a dashpot of their
/// own; from contact inside one segment to complete contact; from no memory to that of many
/// periods.
TEST_P(ArmKernel, AgreesWithThePlainPass) {
  for (const int arms : {1, 2, 4, 7, 8, 9, 20, 33})
    for (const double viscosity : {0.0, 50.0})
      for (const std::int64_t elements : {20, 301}) {
        const ElementLaw law = lawWith(arms, viscosity);
        const RetardationModes modes = retardationModes(law);
        ArmTables tables(law, modes);
        const Scheme scheme = arms % 2 == 0 ? Scheme::Cubic : Scheme::Linear;
        const PreparedProfile line =
            prepareProfile(roughLine(elements, 2, 0.7, elements + arms), scheme);
        for (const double velocity : {1e-6, 1e-3, 0.1, 10.0, 1e4})
          for (const double depth : {1e-8, 1e-7, 1e-6, 1e-5})
            expectPlain(line, tables, velocity, depth);
      }
}

/// The same line with each segment cut into equal parts of its own cubic.
Line cutInto(int parts, const Line& line) {
  Line fine = line;
  fine.spacing = line.spacing / parts;
  fine.height.clear();
  fine.slopeAfter.clear();
  for (std::size_t i = 0; i < line.nodes(); ++i) {
    const std::size_t to = (i + 1) % line.nodes();
    const Cubic cubic =
        hermiteCubic(line.height[i], line.height[to], line.slopeAfter[i] * line.spacing,
                     line.slopeLeftOf(to) * line.spacing);
    for (int part = 0; part < parts; ++part) {
      const double t = static_cast<double>(part) / parts;
      fine.height.push_back(cubic(t));
      fine.slopeAfter.push_back(cubic.derivative(t) / line.spacing);
    }
  }
  return fine;
}

/// However far apart the nodes are, a pass finds all that its curve does between them: contact
/// begins and ends where it does on the same curve in shorter segments.
TEST_P(ArmKernel, NoEventInsideASegmentIsMissed) {
  for (const int arms : {1, 3, 8})
    for (std::int64_t realization = 0; realization < 12; ++realization) {
      const ElementLaw law = lawWith(arms);
      const RetardationModes modes = retardationModes(law);
      ArmTables tables(law, modes), tablesOfParts(law, modes);
      const Line curve = roughLine(40, 1, 0.3, realization);
      const PreparedProfile line = prepareProfile(curve, Scheme::Cubic);
      const PreparedProfile parts = prepareProfile(cutInto(16, curve), Scheme::Cubic);
      for (const double velocity : {1e-4, 1e-2, 1.0, 100.0})
        for (const double depth : {1e-7, 1e-6, 3e-6}) {
          SCOPED_TRACE(testing::Message() << arms << " arms, line " << realization << ", "
                                          << velocity << " m/s, " << depth << " m deep");
          const ArmBalance balance = ArmSolver(line, tables, velocity).atDepth(depth);
          ASSERT_TRUE(balance.isMet());
          ArmPass plain(line, tables.at(velocity, line)->coefficients);
          ArmPass plainOfParts(parts, tablesOfParts.at(velocity, parts)->coefficients);
          plain.runForState(depth, balance.strain);
          plainOfParts.runForState(depth, balance.strain);
          EXPECT_NEAR(plain.sums().contactLength, plainOfParts.sums().contactLength,
                      1e-8 * line.length);
          EXPECT_NEAR(plain.sums().depth, plainOfParts.sums().depth,
                      1e-9 * plainOfParts.sums().depth);
          ArmWorkspace work(tables.at(velocity, line)->vectors);
          runArmPass(line, tables.at(velocity, line)->vectors, depth, balance.strain,
                     Output::Everything, work);
          EXPECT_NEAR(work.sums.contactLength, plainOfParts.sums().contactLength,
                      1e-8 * line.length);
          EXPECT_NEAR(work.sums.depth, plainOfParts.sums().depth, 1e-9 * plainOfParts.sums().depth);
        }
    }
}

/// The plain pass, from where a search in vectors has ended, finds force and period met and the
/// same friction.
TEST_P(ArmKernel, ItsBalancesAreThoseOfThePlainPass) {
  const PreparedProfile line = prepareProfile(roughLine(1000, 2), Scheme::Cubic);
  for (const int arms : {1, 5, 20, 40})
    for (const double newton : {0.0034, 0.1, 10.0}) {
      const ElementLaw law = lawWith(arms);
      const RetardationModes modes = retardationModes(law);
      ArmTables tables(law, modes);
      Load load;
      load.normalForce = newton;
      for (const double velocity : {1e-5, 1e-2, 1.0, 1e3}) {
        SCOPED_TRACE(testing::Message() << arms << " arms, " << newton << " N, " << velocity);
        const ArmState found = slideWithArms(line, tables, load, velocity);
        ASSERT_TRUE(found.balance.isMet());
        ArmPass plain(line, tables.at(velocity, line)->coefficients);
        plain.runForState(found.balance.force.depth, found.balance.strain);
        const double area = newton / (4 * law.equilibriumModulus);
        EXPECT_NEAR(plain.sums().depth, area, 1e-10 * area);
        const double friction = 4 * law.equilibriumModulus * plain.sums().dissipation;
        EXPECT_NEAR(found.result.powerDissipated / velocity, friction, 1e-10 * friction);
        double scale = found.balance.force.depth;
        for (const double strain : found.balance.strain) scale = std::max(scale, std::abs(strain));
        for (std::size_t i = 0; i < law.arms.size(); ++i) {
          const double c = velocity * law.arms[i].relaxationTime;
          EXPECT_LT(std::abs(plain.creepChange()[i]) / -std::expm1(-line.length / c),
                    1e-10 * scale);
        }
      }
    }
}

/// What a search begins from, and whether tables are made or found, changes nothing but its cost.
TEST_P(ArmKernel, ASweepFindsWhatEachVelocityFindsByItself) {
  const PreparedProfile line = prepareProfile(roughLine(500, 2), Scheme::Cubic);
  Scene scene;
  scene.elastomer = treadCompound();
  const SteadySolver sliding(scene);
  std::vector<double> velocities;
  for (int i = 0; i < 25; ++i) velocities.push_back(std::pow(10.0, -6 + 0.4 * i));
  std::vector<SteadyResult> swept(velocities.size()), again(velocities.size());
  ASSERT_TRUE(sliding.sweep(line, scene.load, velocities, swept));
  ASSERT_TRUE(sliding.sweep(line, scene.load, velocities, again));
  double passes = 0;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    const SteadyResult alone = SteadySolver(scene).at(line, velocities[i]).result;
    EXPECT_NEAR(swept[i].mu, alone.mu, 1e-10 * alone.mu) << velocities[i];
    EXPECT_NEAR(swept[i].indentation, alone.indentation, 1e-10 * alone.indentation);
    EXPECT_EQ(swept[i].mu, again[i].mu);
    EXPECT_EQ(swept[i].indentation, again[i].indentation);
    passes += swept[i].passes;
  }
  EXPECT_LT(passes / static_cast<double>(velocities.size()), 6);
}

/// A march in time on the same line: implicit steps of all elements instead of one pass. Its own
/// error falls to a quarter as steps and spacing are halved, so the change tells it.
TEST_P(ArmKernel, AMarchInFineStepsEndsAtTheSameFriction) {
  const double velocity = 0.3, newton = 0.05;
  const Elastomer elastomer = prony(1e6, {{1e6, 3e-3}, {4e6, 3e-4}, {2e7, 1e-5}});
  const ElementLaw law = elementLaw(elastomer);
  const auto marched = [&](std::int64_t oversampling) {
    const auto line = std::make_shared<const Line>(roughLine(40, oversampling));
    TimeMarch march(line, prepareProfile(*line, Scheme::Cubic).lowestHeight, law);
    const MarchLoad load{LoadKind::Force, newton, 0};
    march.settleAtRest(load);
    const double dx = line->spacing;
    double advance = 0;
    // A period takes 22 of the longest relaxation times.
    for (int period = 0; period < 3; ++period) {
      advance = 0;
      for (std::size_t i = 0; i < line->nodes(); ++i)
        advance += march.step(load, dx / velocity, dx).lineWork;
    }
    return advance / (newton * dx * static_cast<double>(line->nodes()));
  };
  Scene scene;
  scene.elastomer = elastomer;
  scene.load.normalForce = newton;
  const double steady =
      SteadySolver(scene).at(prepareProfile(roughLine(40, 32), Scheme::Cubic), velocity).result.mu;
  const double coarse = marched(16), fine = marched(32);
  EXPECT_LT(std::abs(fine - steady), std::abs(coarse - fine));
  EXPECT_LT(std::abs(fine / steady - 1), 0.01);
}

}  // namespace

ASPERITY_ON_EACH_INSTRUCTION_SET(ArmKernel);

}  // namespace asperity
