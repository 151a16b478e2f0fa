// The march in time: exactness of each step, and convergence to the steady pass.
#include "core/contact/march/time_march.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/surface/line.h"
#include "tests/core/contact/lines.h"
#include "tests/core/elastomers.h"

namespace asperity {
namespace {

struct Marched {
  double mu, indentation;
  MarchStep last;
  double imbalance;   // of power over the last period
  double depthForce;  // N, 4 G dx sum y
};

double lowestOf(const Line& line) {
  return prepareProfile(line, Scheme::Cubic).lowestHeight;
}

MarchLoad underForce(double force) {
  return {LoadKind::Force, force, 0};
}

ElementLaw kelvin(double tau = kTau) {
  Elastomer elastomer;
  elastomer.shearModulus = kModulus;
  elastomer.relaxationTime = tau;
  return elementLaw(elastomer);
}

Line flatLine(int nodes) {
  Line line = roughLine(nodes);
  for (double& height : line.height) height = 0;
  for (double& slope : line.slopeAfter) slope = 0;
  return line;
}

/// Marches with dt = dx / v from the flat surface until the shape moves along unchanged.
Marched marchToSteady(const Line& line, double velocity, double force, int periods,
                      const ElementLaw& law = kelvin()) {
  TimeMarch march(std::make_shared<Line>(line), lowestOf(line), law);
  const double dx = line.spacing, dt = dx / velocity;
  Marched result{};
  const auto steps = static_cast<int>(line.nodes());
  for (int period = 0; period < periods; ++period) {
    double given = 0, dissipated = 0, advance = 0;
    for (int i = 0; i < steps; ++i) {
      result.last = march.step(underForce(force), dt, dx);
      given += result.last.lineWork - result.last.gapWork;
      advance += result.last.lineWork;
      dissipated += result.last.dissipated;
    }
    result.mu = advance / (force * dx * steps);
    result.imbalance = given / dissipated - 1;
  }
  result.indentation = march.indentation();
  for (const double depth : march.depth()) result.depthForce += 4 * kModulus * dx * depth;
  return result;
}

TEST(TimeMarch, EveryStepKeepsForcePressureAndShape) {
  const Line line = roughLine(200, 2);
  TimeMarch march(std::make_shared<Line>(line), lowestOf(line), kelvin());
  const double highest = *std::max_element(line.height.begin(), line.height.end());
  for (int i = 0; i < 500; ++i) {
    const double distance = line.spacing * (i % 3 == 0 ? 0.37 : 1.21);  // off the nodes too
    const MarchStep step = march.step(underForce(0.01), distance / 0.3, distance);
    EXPECT_NEAR(step.normalForce / 0.01, 1, 1e-12);
    for (std::size_t k = 0; k < line.nodes(); ++k) {
      EXPECT_GE(march.pressure()[k], 0);
      // u <= z - d
      EXPECT_GE(march.depth()[k] - (march.indentation() - march.heightAboveMinimum()[k]),
                -4e-16 * highest);
    }
  }
}

/// Work on elements with a dashpot is stored or dissipated, in every step; all three are summed
/// apart.
TEST(TimeMarch, WorkIsStoredOrDissipated) {
  const Line line = roughLine(200, 2);
  for (const ElementLaw& law : {kelvin(), elementLaw(prony(1e6, {{1e6, 1}, {4e6, 1e-2}}, 200))}) {
    TimeMarch march(std::make_shared<Line>(line), lowestOf(line), law);
    for (int i = 0; i < 300; ++i) {
      const double distance = line.spacing * 0.8;
      const double velocity = i < 100 ? 0.01 : i < 200 ? 1 : 100;  // with sudden changes
      const MarchStep step = march.step(underForce(0.01), distance / velocity, distance);
      const double scale = std::abs(step.work) + std::abs(step.stored) + step.dissipated;
      ASSERT_NEAR(step.work, step.stored + step.dissipated, 1e-12 * scale) << i;
      ASSERT_GE(step.dissipated, 0) << i;
    }
  }
}

/// What the line does by its way and by sinking is stored or dissipated, step by step: through
/// sliding, rest and back, in steps that resolve the dashpot. The difference of the two works is
/// that of elements met within a step.
TEST(TimeMarch, FrictionAndSinkingDoTheWork) {
  const Line line = roughLine(200, 2);
  for (const ElementLaw& law : {kelvin(), elementLaw(prony(1e6, {{1e6, 1}, {4e6, 1e-2}}, 4e3))}) {
    TimeMarch march(std::make_shared<Line>(line), lowestOf(line), law);
    for (int i = 0; i < 400; ++i) {
      const double ways[] = {0.8, 0, -0.4, 1e-9};  // of a node
      const double distance = line.spacing * ways[i / 100], before = march.indentation();
      const MarchStep step = march.step(underForce(0.01), 0.8 * line.spacing / 0.5, distance);
      const double done =
          step.slopeForce * distance + step.normalForce * (march.indentation() - before);
      const double scale = std::abs(step.lineWork) + std::abs(step.stored) + step.dissipated;
      ASSERT_NEAR(done, step.stored + step.dissipated + step.gapWork, 1e-6 * scale) << i;
      ASSERT_GE(step.gapWork, -1e-12 * scale) << i;
    }
  }
}

/// The two readings of friction, by the line's way in a step and by its slopes where it is, agree
/// with each other and with the resolved pass at the order of the scheme.
TEST(TimeMarch, BothReadingsOfFrictionConverge) {
  const double velocity = 0.5, force = 0.02;
  const auto lines = [](std::size_t nodes) {
    return std::vector<std::pair<const char*, Line>>{{"parabola", parabolaLine(0.02, nodes, 0.5)},
                                                     {"wedge", wedgeLine(0.02, nodes, 2e-3)},
                                                     {"sine", sineLine(0.02, nodes, 5e-6, 4)}};
  };
  struct Errors {
    double work = 0, place = 0;  // the largest of some lines: edges of contact fall between nodes
  };
  const auto errorsOf = [&](std::size_t shape, std::initializer_list<std::size_t> allNodes) {
    Errors errors;
    for (const std::size_t nodes : allNodes) {
      const Line line = lines(nodes)[shape].second;
      const PreparedProfile profile = prepareProfile(line, Scheme::Cubic);
      const double exact = slideAtForce(profile, withRelaxationLength(velocity * kTau), force).mu;
      TimeMarch march(std::make_shared<Line>(line), profile.lowestHeight, kelvin());
      double ways = 0, places = 0;
      for (std::size_t i = 0; i < 2 * nodes; ++i) {
        const MarchStep step = march.step(underForce(force), line.spacing / velocity, line.spacing);
        if (i < nodes) continue;
        ways += step.slopeForce / force / static_cast<double>(nodes);
        places += march.slopeForce() / force / static_cast<double>(nodes);
      }
      errors.work = std::max(errors.work, std::abs(ways / exact - 1));
      errors.place = std::max(errors.place, std::abs(places / exact - 1));
    }
    return errors;
  };
  for (std::size_t shape = 0; shape < 3; ++shape) {
    const char* name = lines(8)[shape].first;
    const Errors coarse = errorsOf(shape, {400, 500, 640}),
                 fine = errorsOf(shape, {1600, 2000, 2560});
    EXPECT_LT(coarse.work, 0.01) << name;
    EXPECT_LT(coarse.place, 0.25) << name;
    EXPECT_LT(fine.work, coarse.work / 6 + 1e-12) << name;  // second order: 16; a wedge's is exact
    EXPECT_LT(fine.place, coarse.place / 3.5) << name;      // first order: 4
  }
}

/// Pressed at rest for ever, contact is even: nothing pushes to a side. Of a wedge, too, whose tip
/// has two slopes.
TEST(TimeMarch, NothingPushesSidewaysInStaticEquilibrium) {
  for (const Line& line :
       {parabolaLine(0.02, 400, 0.5), wedgeLine(0.02, 400, 2e-3), roughLine(200, 4)}) {
    TimeMarch march(std::make_shared<Line>(line), lowestOf(line), kelvin());
    march.settleAtRest(underForce(0.02));
    const MarchStep step = march.step(underForce(0.02), 1e-5, 0);
    EXPECT_LT(std::abs(step.slopeForce) / 0.02, 1e-4 * line.rmsSlope);
  }
}

/// Under a pressure that grows evenly one step is as exact as a thousand, its energies too: those
/// of a flat line, where every element is pressed alike.
TEST(TimeMarch, EnergiesOfALongStepAreThoseOfManyShortOnes) {
  const Line line = flatLine(8);
  for (const double duration : {1e-6, 1e-2, 1e3})
    for (const auto& [name, elastomer] : allElastomers()) {
      const ElementLaw law = elementLaw(elastomer);
      if (law.viscosity > 0) continue;  // pressed evenly in a step, not growing
      TimeMarch once(std::make_shared<Line>(line), 0, law), often = once;
      const auto pressed = [&](TimeMarch& march, int steps) {
        MarchStep sum;
        march.settleAtRest(underForce(1));
        for (int i = 1; i <= steps; ++i) {
          const MarchStep step = march.step(underForce(1 + 2.0 * i / steps), duration / steps, 0);
          sum.dissipated += step.dissipated;
          sum.work += step.work;
          sum.stored += step.stored;
        }
        return sum;
      };
      const MarchStep one = pressed(once, 1), many = pressed(often, 1000);
      EXPECT_NEAR(once.indentation(), often.indentation(), 1e-12 * once.indentation()) << name;
      EXPECT_NEAR(one.work, many.work, 1e-10 * many.work) << name << ", " << duration;
      EXPECT_NEAR(one.dissipated, many.dissipated, 1e-10 * many.work) << name << ", " << duration;
      EXPECT_GE(one.dissipated, 0) << name;
    }
}

/// Once the shape is stationary F_N = 4 G dx sum y, and the power that the line puts in is
/// dissipated in the dashpots, but for what closing gaps within a step takes, which shrinks with
/// dx. So it is at any resolution of the line with steps that resolve the dashpot.
TEST(TimeMarch, SteadyIdentitiesHoldInShortSteps) {
  for (const std::int64_t oversampling : {1, 2, 4})
    for (const double velocity : {0.5, 3.0, 20.0}) {
      const Line line = roughLine(128, oversampling);
      TimeMarch march(std::make_shared<Line>(line), lowestOf(line), kelvin());
      const double force = 0.01;
      const Marched steady = marchToSteady(line, velocity, force, velocity > 1 ? 60 : 4);
      EXPECT_LT(std::abs(steady.imbalance), 1e-9) << oversampling << " " << velocity;
      EXPECT_NEAR(steady.last.normalForce / force, 1, 1e-12);
      EXPECT_NEAR(steady.last.stored, 0, 1e-9 * steady.last.work);
      EXPECT_NEAR(steady.depthForce / force, 1, 1e-9);
    }
}

/// Least-squares slope of log |error| over log dx.
double orderOf(const std::vector<double>& errors) {  // dx halved from one to the next
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const auto n = static_cast<double>(errors.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double x = -static_cast<double>(i), y = std::log2(std::abs(errors[i]));
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// Root mean square over a few lines of the relative errors of friction and of depth.
std::pair<double, double> marchErrors(double velocity, double force, std::int64_t oversampling) {
  constexpr int kLines = 4;
  double friction = 0, depth = 0;
  for (int line = 0; line < kLines; ++line) {
    const SteadyResult exact =
        slideAtForce(prepareProfile(roughLine(128, 64, 0.7, line), Scheme::Cubic),
                     {kModulus, kTau, velocity}, force);
    const Marched marched =
        marchToSteady(roughLine(128, oversampling, 0.7, line), velocity, force, 3);
    friction += std::pow(marched.mu / exact.mu - 1, 2) / kLines;
    depth += std::pow(marched.indentation / exact.indentation - 1, 2) / kLines;
  }
  return {std::sqrt(friction), std::sqrt(depth)};
}

/// With dt = dx / v and dx shrinking together friction and depth tend to those of the steady pass,
/// at second order, in region I, II and III.
TEST(TimeMarch, ReachesTheSteadyPassAtSecondOrder) {
  for (const double velocity : {0.1, 0.3, 3.0}) {
    std::vector<double> friction, depth;
    for (const std::int64_t oversampling : {1, 2, 4, 8, 16}) {
      const auto [ofFriction, ofDepth] = marchErrors(velocity, 0.2, oversampling);
      friction.push_back(ofFriction);
      depth.push_back(ofDepth);
    }
    EXPECT_GT(orderOf(friction), 1.8) << velocity;
    EXPECT_LT(friction.back(), 1e-3) << velocity;
    // The few contact edges fall anywhere between nodes, which scatters the depth's error.
    EXPECT_GT(orderOf(depth), 1.7) << velocity;
    EXPECT_LT(depth.back(), 1e-4) << velocity;
  }
}

/// In steps of up to eight relaxation times friction is still that of the steady pass: a pressure
/// that lagged by half a step would make it four times as large.
TEST(TimeMarch, LongStepsDoNotAddFriction) {
  for (const double velocity : {5e-3, 0.02, 0.05})
    EXPECT_LT(marchErrors(velocity, 0.2, 4).first, 0.06) << velocity;
}

/// A dashpot that is far too fast for the steps does not change friction of the arms beside it.
TEST(TimeMarch, ADashpotFasterThanAStepChangesNothing) {
  const std::vector<Arm> arms{{3e6, 1e-2}, {5e6, 1e-3}, {1e7, 1e-4}};
  const Line line = roughLine(128, 4);
  for (const double velocity : {0.02, 0.3, 3.0}) {
    const auto friction = [&](double viscosity) {
      return marchToSteady(line, velocity, 0.05, 12, elementLaw(prony(1e6, arms, viscosity))).mu;
    };
    EXPECT_NEAR(friction(1e-2) / friction(0), 1, 1e-3) << velocity;
  }
}

/// A pressed element released for a time t relaxes by exp(-t / tau), however the time is divided.
TEST(TimeMarch, FreeRelaxationIsExact) {
  const Line line = roughLine(100);
  for (const int pieces : {1, 7, 100}) {
    TimeMarch march(std::make_shared<Line>(line), lowestOf(line), kelvin());
    march.setState(std::vector<double>(100, 1e-3), 1e-3);
    const MarchLoad lifted{LoadKind::Indentation, 0, 1e-30};
    for (int i = 0; i < pieces; ++i) march.step(lifted, 2 * kTau / pieces, 0);
    EXPECT_NEAR(march.depth()[50], 1e-3 * std::exp(-2), 1e-15);
  }
}

/// Pressed by a constant force without sliding, complete contact sinks as a Kelvin body does.
TEST(TimeMarch, CreepOfAFlatLine) {
  const Line flat = flatLine(50);
  TimeMarch march(std::make_shared<Line>(flat), 0, kelvin());
  const double force = 0.01, end = force / (4 * kModulus * flat.length);
  for (int i = 1; i <= 10; ++i) {
    march.step(underForce(force), 0.3 * kTau, 0);
    EXPECT_NEAR(march.indentation() / end, -std::expm1(-0.3 * i), 1e-13);
  }
}

TEST(TimeMarch, ElasticElementsHaveNoMemory) {
  const Line line = roughLine(200);
  TimeMarch march(std::make_shared<Line>(line), lowestOf(line), kelvin(0));
  for (int i = 0; i < 50; ++i) {
    march.step(underForce(0.01), 1, line.spacing);
    for (std::size_t k = 0; k < line.nodes(); ++k) {
      const double pressed = std::max(march.indentation() - march.heightAboveMinimum()[k], 0.0);
      EXPECT_DOUBLE_EQ(march.depth()[k], pressed);
      EXPECT_DOUBLE_EQ(march.pressure()[k], 4 * kModulus * pressed);
    }
  }
}

/// The root on a threshold itself: rounding must not let an element come and go for ever.
TEST(TimeMarch, ABalanceOnAThresholdEnds) {
  for (const std::size_t nodes : {50UL, 64UL, 100UL})
    for (int i = 1; i <= 200; ++i) {
      const Line wedge = wedgeLine(0.02, nodes, 1e-3);
      TimeMarch march(std::make_shared<Line>(wedge), 0, kelvin());
      const double force = 4 * kModulus * wedge.spacing * 1e-6 * i;
      for (int step = 0; step < 5; ++step) {
        const MarchStep result = march.step(underForce(force), 3e-5, 0);
        EXPECT_NEAR(result.normalForce / force, 1, 1e-11);
      }
    }
}

TEST(TimeMarch, ALineMovedByAPeriodIsTheSameLine) {
  const Line line = roughLine(64, 2);
  TimeMarch march(std::make_shared<Line>(line), 0, kelvin());
  for (std::size_t i = 0; i < line.nodes(); ++i)
    EXPECT_EQ(march.heightAboveMinimum()[i], line.height[i]);
  march.setDistance(line.spacing * 5);
  for (std::size_t i = 0; i < line.nodes(); ++i)
    EXPECT_NEAR(march.heightAboveMinimum()[(i + 5) % line.nodes()], line.height[i], 1e-18);
  march.setDistance(-line.spacing * 2.5);  // backwards, between nodes
  const Line fine = roughLine(64, 4);
  for (std::size_t i = 0; i < line.nodes(); ++i)
    EXPECT_NEAR(march.heightAboveMinimum()[i], fine.height[(2 * i + 5) % fine.nodes()], 2e-9);
}

/// The contact spots, counted anew once around the period.
std::size_t contactSpotsAround(const std::vector<double>& pressure) {
  const std::size_t n = pressure.size();
  std::size_t ends = 0;
  for (std::size_t i = 0; i < n; ++i)
    ends += pressure[i] > 0 && !(pressure[(i + 1) % n] > 0) ? 1 : 0;
  const bool isWhole = std::ranges::all_of(pressure, [](double p) { return p > 0; });
  return isWhole ? 1 : ends;
}

/// One summit slides once around: its contact is one, at the seam of the period as elsewhere.
TEST(TimeMarch, AContactAcrossTheSeamIsOne) {
  const int nodes = 200;
  const Line line = parabolaLine(0.02, nodes, 1);
  TimeMarch march(std::make_shared<Line>(line), lowestOf(line), kelvin());
  int across = 0;
  for (int i = 0; i < 2 * nodes; ++i) {
    const MarchStep step = march.step(underForce(0.01), line.spacing, line.spacing);
    const std::vector<double>& pressure = march.pressure();
    EXPECT_EQ(step.contacts, 1U) << i;
    across += pressure.front() > 0 && pressure.back() > 0 ? 1 : 0;
  }
  EXPECT_GT(across, 2);
  EXPECT_LT(across, nodes);
}

/// One contact, many, and one all around.
TEST(TimeMarch, ContactsAreCountedOnceAroundThePeriod) {
  const Line line = roughLine(300, 1);
  for (const double force : {1e-4, 0.3, 1e3}) {
    TimeMarch march(std::make_shared<Line>(line), lowestOf(line), kelvin());
    std::size_t most = 0;
    for (int i = 0; i < 300; ++i) {
      const MarchStep step = march.step(underForce(force), line.spacing, line.spacing);
      ASSERT_EQ(step.contacts, contactSpotsAround(march.pressure())) << force << " N, step " << i;
      most = std::max(most, step.contacts);
    }
    EXPECT_EQ(most > 1, force == 0.3) << force << " N";
  }
}

}  // namespace
}  // namespace asperity
