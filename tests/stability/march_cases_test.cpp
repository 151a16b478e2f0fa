// Hard cases of the march in time: steps far shorter and far longer than the relaxation, sudden
// changes, reversal, rest, and very many steps.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/contact/line/prepared_profile.h"
#include "core/contact/march/time_march.h"
#include "core/surface/line_source.h"

namespace asperity {
namespace {

constexpr double kModulus = 1e7, kForce = 0.0034;

std::shared_ptr<const Line> roughLine(std::int64_t elements) {
  Scene scene;
  scene.surface.elements = elements;
  return std::make_shared<Line>(LineSource(scene, 1).make(0));
}

TimeMarch marchOf(const std::shared_ptr<const Line>& line, double tau) {
  Elastomer elastomer;
  elastomer.shearModulus = kModulus;
  elastomer.relaxationTime = tau;
  return {line, prepareProfile(*line, Scheme::Cubic).lowestHeight, elementLaw(elastomer)};
}

/// How far a step is from what always holds.
struct Worst {
  double balance = 0;   // |F_N - wanted| / wanted
  double energy = 0;    // |work - stored - dissipated| / their sum, or 1e-9 of what is stored
  double negative = 0;  // -p, -y
  double through = 0;   // u above z - d, in ulp of max |z| and d
  bool finite = true;

  void take(const TimeMarch& march, const MarchStep& step, double force) {
    balance = std::max(balance, std::abs(step.normalForce / force - 1));
    const double scale = std::abs(step.work) + std::abs(step.stored) + step.dissipated +
                         1e-9 * force * march.indentation();
    if (scale > 0)
      energy = std::max(energy, std::abs(step.work - step.stored - step.dissipated) / scale);
    finite = finite && std::isfinite(step.indentation) && std::isfinite(step.lineWork);
    double highest = march.indentation();
    for (const double rise : march.heightAboveMinimum()) highest = std::max(highest, rise);
    const double ulp = highest * std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < march.depth().size(); ++i) {
      finite = finite && std::isfinite(march.depth()[i]) && std::isfinite(march.pressure()[i]);
      negative = std::max({negative, -march.pressure()[i], -march.depth()[i]});
      const double gap = march.depth()[i] - (march.indentation() - march.heightAboveMinimum()[i]);
      through = std::max(through, -gap / ulp);
    }
  }
};

void expectSound(const std::string& name, const Worst& worst, double balance) {
  fmt::print("{:<44} F_N {:8.1e}  energy {:8.1e}  through {:5.2f} ulp\n", name, worst.balance,
             worst.energy, worst.through);
  EXPECT_TRUE(worst.finite) << name;
  EXPECT_LE(worst.balance, balance) << name;
  EXPECT_LE(worst.energy, std::max(1e-10, balance)) << name;
  EXPECT_EQ(worst.negative, 0) << name;
  EXPECT_LE(worst.through, 4) << name;
}

MarchLoad pressedBy(double force) {
  return {LoadKind::Force, force, 0};
}

/// The step over the relaxation time from 1e-12 to 1e12, sliding one node a step.
TEST(MarchCases, StepsOfAnyLength) {
  const auto line = roughLine(200);
  for (int exponent = -12; exponent <= 12; exponent += 3) {
    const double tau = 1e-3, dt = tau * std::pow(10, exponent);
    TimeMarch march = marchOf(line, tau);
    Worst worst;
    for (int i = 0; i < 400; ++i)
      worst.take(march, march.step(pressedBy(kForce), dt, line->spacing * (i % 2 ? 0.37 : 1)),
                 kForce);
    expectSound(fmt::format("dt / tau = 1e{}", exponent), worst, 1e-9);
  }
}

/// The velocity jumps by 1e6 either way, turns round and passes through zero.
TEST(MarchCases, SuddenSteps) {
  const auto line = roughLine(200);
  TimeMarch march = marchOf(line, 1e-3);
  Worst worst;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> pick(0, 4);
  constexpr double kVelocities[] = {1e-3, 1e3, -1e3, 0, -1e-3};
  for (int i = 0; i < 4000; ++i) {
    const double velocity = kVelocities[pick(random)];
    const double way = 0.8 * line->spacing;
    const double dt = velocity != 0 ? way / std::abs(velocity) : 1e-5;
    worst.take(march, march.step(pressedBy(kForce), dt, velocity * dt), kForce);
  }
  expectSound("velocity steps of 1e6, reversal, rest", worst, 1e-9);
}

/// Loads from far below an element's to far above the heights.
TEST(MarchCases, AnyLoad) {
  const auto line = roughLine(200);
  for (int exponent = -12; exponent <= 12; exponent += 4) {
    const double force = std::pow(10, exponent) * kModulus * 5e-7 * 0.02;
    TimeMarch march = marchOf(line, 1e-3);
    Worst worst;
    for (int i = 0; i < 400; ++i)
      worst.take(march, march.step(pressedBy(force), line->spacing, line->spacing), force);
    expectSound(fmt::format("Fbar = 1e{}", exponent), worst, 1e-9);
  }
}

struct Period {
  double mu, dissipated, indentation;
};

Period onePeriod(TimeMarch& march, double dt) {
  const Line& line = march.line();
  Period period{};
  for (std::size_t i = 0; i < line.nodes(); ++i) {
    const MarchStep step = march.step(pressedBy(kForce), dt, line.spacing);
    period.mu += step.lineWork;
    period.dissipated += step.dissipated;
  }
  period.mu /= kForce * line.length;
  period.indentation = march.indentation();
  return period;
}

/// Ten million steps: friction, energy and indentation of the last period are those of an early
/// one.
TEST(MarchCases, TenMillionStepsDoNotDrift) {
  const auto line = roughLine(16);
  TimeMarch march = marchOf(line, 1e-3);
  const double dt = line->spacing / 1.0;
  for (int i = 0; i < 100; ++i) onePeriod(march, dt);
  const Period early = onePeriod(march, dt);
  const std::size_t memory = march.depth().capacity();
  Period late{};
  for (int i = 0; i < 10000000 / 16; ++i) late = onePeriod(march, dt);
  fmt::print("after {:.3g} m: mu off by {:.1e}, energy {:.1e}, indentation {:.1e}\n",
             march.distance(), std::abs(late.mu / early.mu - 1),
             std::abs(late.dissipated / early.dissipated - 1),
             std::abs(late.indentation / early.indentation - 1));
  EXPECT_NEAR(late.mu / early.mu, 1, 1e-9);
  EXPECT_NEAR(late.dissipated / early.dissipated, 1, 1e-9);
  EXPECT_NEAR(late.indentation / early.indentation, 1, 1e-9);
  EXPECT_EQ(march.depth().capacity(), memory);
}

}  // namespace
}  // namespace asperity
