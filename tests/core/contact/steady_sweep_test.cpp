// The shipped path, in vector lanes, against the plain pass, on every instruction set of the
// machine.
#include "core/contact/steady_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/contact/kernels/kernels.h"
#include "core/surface/line.h"
#include "tests/core/contact/allocation_counter.h"
#include "tests/core/contact/fixed_depths.h"
#include "tests/core/contact/instruction_sets.h"
#include "tests/core/contact/lines.h"

namespace asperity {
namespace {

class Sweep : public EachInstructionSet {};

std::vector<double> decades(double from, double to, int points) {
  std::vector<double> values;
  for (int i = 0; i < points; ++i) values.push_back(from * std::pow(to / from, i / (points - 1.0)));
  return values;
}

std::vector<SteadyResult> sweep(const PreparedProfile& line, double force,
                                const std::vector<double>& velocities) {
  std::vector<SteadyResult> results(velocities.size());
  Load load;
  load.normalForce = force;
  EXPECT_TRUE(slideSweep(line, {kModulus, kTau, 0}, load, velocities, results));
  return results;
}

/// Equal to 1e-12; a contact shorter than the spacing h knows its ends to h / length digits less.
void expectSame(const SteadyResult& a, const SteadyResult& b, const PreparedProfile& line) {
  const double contact = b.contactFraction * line.length;
  const double tolerance = 1e-12 * std::max(1.0, line.spacing / contact);
  EXPECT_NEAR(a.mu, b.mu, tolerance * std::abs(b.mu)) << line.spacing / contact;
  EXPECT_NEAR(a.indentation, b.indentation, 1e-12 * b.indentation);
  // A contact that only just touches is as long as the square root of the rounding of the depth.
  EXPECT_NEAR(a.contactFraction * line.length, contact, 1e-5 * line.spacing);
}

TEST_P(Sweep, AgreesWithThePlainPass) {
  const auto velocities = decades(1e-5, 1e4, 19);
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic})
    for (const std::int64_t oversampling : {1, 3}) {
      const PreparedProfile line = prepareProfile(roughLine(701, oversampling), scheme);
      for (const double force : {1e-5, 1e-3, 0.1, 3.0, 100.0}) {
        const auto results = sweep(line, force, velocities);
        for (std::size_t i = 0; i < velocities.size(); ++i) {
          SCOPED_TRACE(testing::Message() << force << " N, " << velocities[i] << " m/s");
          const SteadyResult plain = slideAtForce(line, {kModulus, kTau, velocities[i]}, force);
          EXPECT_EQ(results[i].status, SteadyStatus::Balanced);
          EXPECT_LE(results[i].residual, 1e-12);
          EXPECT_NEAR(results[i].normalForce, plain.normalForce, 1e-12 * force);
          expectSame(results[i], plain, line);
        }
      }
    }
}

TEST_P(Sweep, AgreesWithThePlainPassForThePapersElements) {
  const auto velocities = decades(1e-5, 1e3, 17);
  for (int realization = 0; realization < 3; ++realization) {
    const PreparedProfile line = prepareProfile(roughLine(700, 1, 0.7, realization), Scheme::Nodal);
    for (const double force : {1e-4, 0.0034, 0.1, 10.0}) {
      const auto results = sweep(line, force, velocities);
      for (std::size_t i = 0; i < velocities.size(); ++i) {
        SCOPED_TRACE(testing::Message() << force << " N, " << velocities[i] << " m/s");
        const SteadyResult plain = slideAtForce(line, {kModulus, kTau, velocities[i]}, force);
        EXPECT_EQ(results[i].status, SteadyStatus::Balanced);
        EXPECT_NEAR(results[i].normalForce, force, 1e-10 * force);
        // An element on the edge: its threshold is known to about 1e-11 of the depth.
        EXPECT_NEAR(results[i].mu, plain.mu, 1e-9 * std::abs(plain.mu) + 1e-18);
        EXPECT_NEAR(results[i].indentation, plain.indentation, 1e-10 * plain.indentation);
        EXPECT_NEAR(results[i].marginalShare, plain.marginalShare, 1e-7);
      }
    }
  }
}

/// Corners, plateaus and lowest points at nodes: shapes that rough lines do not have.
TEST_P(Sweep, AgreesWithThePlainPassOnShapes) {
  const auto velocities = decades(1e-4, 1e4, 11);
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic})
    for (const Line& shape : {wedgeLine(0.02, 101, 1e-3), parabolaLine(0.02, 64, 1.0),
                              sineLine(0.02, 300, 5e-7, 7), sineLine(0.02, 300, 0, 7)}) {
      const PreparedProfile line = prepareProfile(shape, scheme);
      for (const double force : {1e-3, 1.0, 1e3}) {
        const auto results = sweep(line, force, velocities);
        for (std::size_t i = 0; i < velocities.size(); ++i)
          expectSame(results[i], slideAtForce(line, {kModulus, kTau, velocities[i]}, force), line);
      }
    }
}

/// A wedge pressed so lightly that its contact is a billionth of a segment: one-sided, mu = slope.
TEST_P(Sweep, ContactsFarShorterThanASegment) {
  const std::vector<double> velocities{1e-3, 1, 1e3, 1e6};
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic})
    for (const std::size_t nodes : {64UL, 101UL, 5000UL}) {
      const PreparedProfile line = prepareProfile(wedgeLine(0.02, nodes, 1e-3), scheme);
      for (const SteadyResult& result : sweep(line, 1e-13, velocities)) {
        EXPECT_EQ(result.status, SteadyStatus::Balanced);
        EXPECT_NEAR(result.mu / 1e-3, 1, 1e-6);
      }
      EXPECT_NEAR(slideAtForce(line, {kModulus, kTau, 1e6}, 1e-13).mu / 1e-3, 1, 1e-6);
    }
}

/// Elastic, or far slower than anything relaxes: the free surface is back at once.
TEST_P(Sweep, WithoutMemory) {
  const std::vector<double> velocities{1e-5, 1e-2, 10};
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
    const PreparedProfile line = prepareProfile(roughLine(301, 2), scheme);
    for (const double tau : {0.0, 1e-300, 1e-30, 1e-15})
      for (const double force : {1e-4, 0.1, 100.0}) {
        Load load;
        load.normalForce = force;
        std::vector<SteadyResult> results(velocities.size());
        slideSweep(line, {kModulus, tau, 0}, load, velocities, results);
        for (std::size_t i = 0; i < velocities.size(); ++i) {
          const SteadyResult plain = slideAtForce(line, {kModulus, tau, velocities[i]}, force);
          EXPECT_EQ(results[i].status, SteadyStatus::Balanced);
          EXPECT_NEAR(results[i].indentation, plain.indentation, 1e-12 * plain.indentation);
          EXPECT_NEAR(results[i].mu, plain.mu, 1e-10 * plain.mu + 1e-290);
        }
      }
  }
}

/// Where nothing relaxes within a period, all depends on F_N / (4 eta v L) and the shape, however
/// far v tau is beyond numbers that tell a surface from one that does not relax at all.
TEST_P(Sweep, MemoryFarBeyondThePeriodKeepsItsDigits) {
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
    const PreparedProfile line = prepareProfile(roughLine(1000, 2), scheme);
    std::vector<SteadyResult> results(1);
    const double velocity = 1e3;
    double first = 0;
    for (const double factor : {1.0, 1e4, 1e8, 1e12}) {
      Load load;
      load.normalForce = 1e-9 * factor;
      slideSweep(line, {kModulus, 1e4 * factor, 0}, load, {&velocity, 1}, results);
      EXPECT_EQ(results[0].status, SteadyStatus::Balanced);
      if (first == 0) first = results[0].mu;
      EXPECT_NEAR(results[0].mu / first, 1, 1e-6) << factor;
      const SteadyResult plain =
          slideAtForce(line, {kModulus, 1e4 * factor, velocity}, load.normalForce);
      EXPECT_EQ(plain.status, SteadyStatus::Balanced);
      EXPECT_NEAR(plain.mu / results[0].mu, 1, 1e-11) << factor;
    }
  }
}

/// The public profile within the limits of the reference test.
TEST_P(Sweep, MeetsTheReference) {
  const PreparedProfile line = prepareProfile(referenceProfile(2), Scheme::Cubic);
  const auto rows = convergedRows();
  for (std::size_t first = 0, count = 0; first < rows.size(); first += count) {
    std::vector<double> velocities;
    for (count = 0; first + count < rows.size(); ++count) {
      if (rows[first + count].normalForce != rows[first].normalForce) break;
      velocities.push_back(rows[first + count].velocity);
    }
    const auto results = sweep(line, rows[first].normalForce, velocities);
    for (std::size_t i = 0; i < count; ++i) {
      const ConvergedRow& row = rows[first + i];
      const bool resolved = row.contactFraction >= 5e-4;
      EXPECT_NEAR(results[i].mu / row.mu, 1, resolved ? 5e-3 : 3e-2);
      EXPECT_NEAR(results[i].contactFraction / row.contactFraction, 1, resolved ? 1e-2 : 3e-2);
    }
  }
}

/// A lane that is finished stays as it was, whoever goes on beside it.
TEST_P(Sweep, NeighboursDoNotMatter) {
  const PreparedProfile line = prepareProfile(roughLine(500, 2), Scheme::Cubic);
  const auto velocities = decades(1e-4, 1e3, 17);
  const auto all = sweep(line, 0.01, velocities);
  for (std::size_t i = 0; i < velocities.size(); ++i)
    expectSame(sweep(line, 0.01, {velocities[i]}).front(), all[i], line);
  for (std::size_t count = 1; count < velocities.size(); ++count) {
    const auto some =
        sweep(line, 0.01, {velocities.begin(), velocities.begin() + static_cast<long>(count)});
    for (std::size_t i = 0; i < count; ++i) expectSame(some[i], all[i], line);
  }
}

TEST_P(Sweep, TheSameCallGivesTheSameBits) {
  const PreparedProfile line = prepareProfile(roughLine(500, 2), Scheme::Cubic);
  const auto velocities = decades(1e-4, 1e3, 17);
  const auto one = sweep(line, 0.01, velocities), two = sweep(line, 0.01, velocities);
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    EXPECT_EQ(one[i].mu, two[i].mu);
    EXPECT_EQ(one[i].contactFraction, two[i].contactFraction);
  }
}

TEST_P(Sweep, AllocatesNothing) {
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
    const PreparedProfile line = prepareProfile(roughLine(500), scheme);
    const auto velocities = decades(1e-4, 1e3, 17);
    std::vector<SteadyResult> results(velocities.size());
    const Load load;
    const long before = allocationsSoFar();
    slideSweep(line, {kModulus, kTau, 0}, load, velocities, results);
    EXPECT_EQ(allocationsSoFar(), before);
  }
}

TEST_P(Sweep, ConstantIndentation) {
  const auto velocities = decades(1e-4, 1e3, 9);
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
    const PreparedProfile line = prepareProfile(roughLine(300), scheme);
    Load load;
    load.kind = LoadKind::Indentation;
    load.depth = 8e-7;
    std::vector<SteadyResult> results(velocities.size());
    slideSweep(line, {kModulus, kTau, 0}, load, velocities, results);
    for (std::size_t i = 0; i < velocities.size(); ++i) {
      const SteadyResult plain = slideAtDepth(line, {kModulus, kTau, velocities[i]}, 8e-7);
      EXPECT_NEAR(results[i].normalForce / plain.normalForce, 1, 1e-12);
      EXPECT_NEAR(results[i].mu / plain.mu, 1, 1e-12);
    }
  }
}

TEST_P(Sweep, StopsWhenAsked) {
  const PreparedProfile line = prepareProfile(roughLine(300), Scheme::Cubic);
  std::stop_source source;
  source.request_stop();
  std::vector<SteadyResult> results(1);
  const double velocity = 1;
  EXPECT_FALSE(
      slideSweep(line, {kModulus, kTau, 0}, {}, {&velocity, 1}, results, source.get_token()));
}

/// A table of forces is no other answer than its rows.
TEST_P(Sweep, ManyForcesAtOnce) {
  const auto velocities = decades(1e-5, 1e3, 9), forces = decades(1e-4, 100, 7);
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Linear, Scheme::Cubic}) {
    const PreparedProfile line = prepareProfile(roughLine(900), scheme);
    std::vector<SteadyResult> table(forces.size() * velocities.size());
    ASSERT_TRUE(slideAtForces(line, {kModulus, kTau, 0}, forces, velocities, table));
    for (std::size_t row = 0; row < forces.size(); ++row) {
      const auto one = sweep(line, forces[row], velocities);
      for (std::size_t i = 0; i < velocities.size(); ++i) {
        const SteadyResult& result = table[row * velocities.size() + i];
        EXPECT_EQ(result.status, SteadyStatus::Balanced);
        const double tolerance = scheme == Scheme::Nodal ? 1e-9 : 1e-12;
        EXPECT_NEAR(result.mu, one[i].mu, tolerance * std::abs(one[i].mu));
        EXPECT_NEAR(result.normalForce / forces[row], 1, 1e-10);
      }
    }
  }
}

/// Depths of another line change what a balance costs, not what it finds.
TEST_P(Sweep, AnotherLineShowsWhereToBegin) {
  const auto velocities = decades(1e-5, 1e3, 17);
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
    const PreparedProfile line = prepareProfile(roughLine(2000, 1, 0.7, 1), scheme);
    const PreparedProfile another = prepareProfile(roughLine(2000, 1, 0.7, 2), scheme);
    for (const double force : {1e-3, 0.1, 10.0}) {
      const auto others = sweep(another, force, velocities), alone = sweep(line, force, velocities);
      auto results = alone;
      Load load;
      load.normalForce = force;
      slideSweep(line, {kModulus, kTau, 0}, load, velocities, results, {}, others);
      int passes = 0, passesAlone = 0;
      for (std::size_t i = 0; i < velocities.size(); ++i) {
        EXPECT_EQ(results[i].status, SteadyStatus::Balanced);
        expectSame(results[i], alone[i], line);
        passes += results[i].passes;
        passesAlone += alone[i].passes;
      }
      if (force < 1) {  // a line in complete contact needs no help
        EXPECT_LT(passes, passesAlone);
      }
    }
  }
}

/// Just before contact is full, where a depth for complete contact is nearly right.
TEST_P(Sweep, NearlyFullContact) {
  for (const Scheme scheme : {Scheme::Linear, Scheme::Cubic}) {
    const PreparedProfile line = prepareProfile(roughLine(400), scheme);
    for (const double velocity : {1e-4, 0.01, 0.3, 10.0}) {
      double low = line.meanHeight, high = 1;  // depths
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        const auto result = slideAtDepth(line, {kModulus, kTau, velocity}, middle);
        (result.contactFraction < 1 - 1e-12 ? low : high) = middle;
      }
      const double full = slideAtDepth(line, {kModulus, kTau, velocity}, high).normalForce;
      for (const double less : {0.0, 1e-8, 1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2}) {
        const auto result = sweep(line, full * (1 - less), {velocity}).front();
        EXPECT_EQ(result.status, SteadyStatus::Balanced) << less;
        EXPECT_LE(result.residual, 1e-12) << less;
        EXPECT_LE(result.passes, 12) << less;
      }
    }
  }
}

/// mu depends on F_N / G, and in units of the rms slope on F_N / (G h).
TEST_P(Sweep, ModuliAndHeightsAreForces) {
  const auto velocities = decades(1e-4, 1e2, 7);
  const Line line = roughLine(500);
  Line higher = line;
  for (double& height : higher.height) height *= 8;
  for (double& slope : higher.slopeAfter) slope *= 8;
  const auto one = sweep(prepareProfile(line, Scheme::Cubic), 0.01, velocities);
  const auto two = sweep(prepareProfile(higher, Scheme::Cubic), 0.08, velocities);
  for (std::size_t i = 0; i < velocities.size(); ++i)
    EXPECT_NEAR(two[i].mu / (8 * one[i].mu), 1, 1e-11);
}

TEST_P(Sweep, PartsOfAPassAddUp) {
  for (const int realization : {0, 1, 2, 3}) {
    const PreparedProfile line =
        prepareProfile(roughLine(2000, 2, 0.3, realization), Scheme::Cubic);
    for (const double depth : {3e-7, 1e-6, 2e-6, 4e-6})
      for (const double relaxationLength : {1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1.0}) {
        FixedDepths whole(depth, relaxationLength), cut(depth, relaxationLength, 16);
        runCubicPasses(line, whole);
        runCubicPasses(line, cut);
        ASSERT_EQ(whole.found.size(), 1U);
        ASSERT_EQ(cut.found.size(), 1U);
        const PassSums &a = whole.found[0], &b = cut.found[0];
        EXPECT_NEAR(b.depth, a.depth, 1e-12 * a.depth);
        EXPECT_NEAR(b.dissipation, a.dissipation, 1e-12 * a.dissipation);
        EXPECT_NEAR(b.stiffness, a.stiffness, 1e-10 * a.stiffness);
        EXPECT_NEAR(b.pressure, a.pressure, 1e-9 * a.pressure);
        EXPECT_EQ(b.gaps, a.gaps);
        if (relaxationLength < 1e-5) {
          EXPECT_GT(b.segmentsInspected, a.segmentsInspected);  // it was cut
        }
      }
  }
}

/// The end of work is asked for inside a pass: here before any has ended.
TEST_P(Sweep, StopsInsideAPass) {
  const PreparedProfile line = prepareProfile(roughLine(20000, 1, 0.0), Scheme::Cubic);
  FixedDepths whole(1e-6, 1e-8), queue(1e-6, 1e-8, 1, 1);
  runCubicPasses(line, whole);
  ASSERT_EQ(whole.found.size(), 1U);
  EXPECT_GT(whole.found[0].segmentsInspected, 300);  // it looks up every 256 steps
  EXPECT_LT(whole.found[0].segmentsInspected, 256 * (whole.timesAsked() + 1));
  runCubicPasses(line, queue);
  EXPECT_TRUE(queue.found.empty());
}

ASPERITY_ON_EACH_INSTRUCTION_SET(Sweep);

}  // namespace
}  // namespace asperity
