// What frames hold on request: slopes of the line, time since contact, power dissipated.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <thread>

#include "core/contact/march/time_march.h"
#include "core/run/rigid_line.h"
#include "core/run/runner.h"
#include "core/run/simulation.h"
#include "core/run/steady_frames.h"
#include "tests/core/elastomers.h"

namespace asperity {
namespace {

constexpr FrameFields kEverything{true, true, true};

Scene rough(double velocity = 0.2) {
  Scene scene;
  scene.surface.elements = 500;
  scene.load.normalForce = 0.05;
  scene.sliding.velocity = velocity;
  return scene;
}

Scene withElastomer(Rheology rheology, double velocity = 0.2) {
  Scene scene = rough(velocity);
  scene.elastomer.rheology = rheology;
  if (rheology == Rheology::Prony) {
    scene.elastomer.arms = {{2e7, 1e-2}, {1e7, 1e-3}, {3e7, 1e-4}};
    scene.elastomer.viscosity = 2e3;
  }
  return scene;
}

std::shared_ptr<const Scene> shared(const Scene& scene) {
  return std::make_shared<const Scene>(scene);
}

double integral(const std::vector<double>& values, double spacing) {
  return spacing * std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(ContactAge, IsTheWayToTheContactAheadOverTheVelocity) {
  const std::vector<double> pressure{0, 0, 5, 0, 0, 0, 1, 2, 0, 0};
  const std::vector<double> forward{0.2, 0.1, 0, 0.3, 0.2, 0.1, 0, 0, 0.4, 0.3};
  const std::vector<double> backward{0.3, 0.4, 0, 0.1, 0.2, 0.3, 0, 0, 0.1, 0.2};
  const std::vector<double> ahead = steadyContactAge(pressure, 0.05, 0.5);
  const std::vector<double> behind = steadyContactAge(pressure, 0.05, -0.5);
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    EXPECT_NEAR(ahead[i], forward[i], 1e-12) << i;
    EXPECT_NEAR(behind[i], backward[i], 1e-12) << i;
  }
}

TEST(ContactAge, WithoutContactOrSlidingThereIsNone) {
  for (const double age : steadyContactAge(std::vector<double>(4), 0.1, 1))
    EXPECT_TRUE(std::isinf(age));
  const std::vector<double> resting = steadyContactAge(std::vector<double>{0, 3, 0}, 0.1, 0);
  EXPECT_TRUE(std::isinf(resting[0]));
  EXPECT_EQ(resting[1], 0);
}

/// A free Kelvin surface comes back as u = u_0 exp(-t / tau), so the age can be read from the
/// depths of two neighbours behind one contact.
TEST(ContactAge, AgreesWithTheFreeSurface) {
  const SteadyFrames frames(shared(rough()), kEverything);
  const Frame frame = frames.frame(0, 1, 25);
  const double tau = frame.scene->elastomer.relaxationTime;
  int compared = 0;
  for (std::size_t i = 0; i + 1 < frame.pressure.size(); ++i) {
    if (frame.pressure[i] > 0 || frame.pressure[i + 1] > 0) continue;
    const double ages = frame.sinceContact[i] - frame.sinceContact[i + 1];
    // Another contact has come between; or all but nothing is left to come back.
    if (ages < 0 || frame.surfaceHeight[i] > -1e-6 * frame.state.indentation) continue;
    EXPECT_NEAR(ages, tau * std::log(frame.surfaceHeight[i + 1] / frame.surfaceHeight[i]),
                1e-3 * ages)
        << i;
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

/// Power in is power out: the integral over all elements is F_x v.
TEST(Power, OfSteadySlidingIsFrictionTimesVelocity) {
  for (const Rheology rheology : {Rheology::Kelvin, Rheology::StandardSolid, Rheology::Prony}) {
    for (const double velocity : {0.01, 1.0, 30.0}) {
      const SteadyFrames frames(shared(withElastomer(rheology, velocity)), kEverything);
      const Frame frame = frames.frame(0, 1, 25);
      const double wanted = frame.state.tangentialForce * velocity;
      EXPECT_NEAR(integral(frame.power, frame.spacing), wanted, 0.02 * wanted)
          << static_cast<int>(rheology) << " " << velocity;
      for (const double power : frame.power) EXPECT_GE(power, 0);
    }
  }
}

/// The sum over points is all that is inexact: it converges to the power that goes in.
TEST(Power, ConvergesWithThePoints) {
  double last = 1;
  for (const int oversampling : {20, 80, 320}) {
    Scene scene = rough();
    scene.accuracy.oversampling = oversampling;
    const SteadyFrames frames(shared(scene), kEverything);
    const Frame frame = frames.frame(0, 1, 25);
    const double wanted = frames.result().powerDissipated;
    const double error = std::abs(integral(frame.power, frame.spacing) / wanted - 1);
    EXPECT_LT(error, 0.7 * last) << oversampling;
    last = error;
  }
  EXPECT_LT(last, 5e-4);
}

TEST(Power, OfAnElasticBodyIsNone) {
  const SteadyFrames frames(shared(withElastomer(Rheology::Elastic)), kEverything);
  for (const double power : frames.frame(0, 1, 25).power) EXPECT_EQ(power, 0);
}

/// Element by element what a step sums up.
TEST(Power, OfAMarchAddsUpToWhatItsStepsDissipate) {
  for (const Rheology rheology : {Rheology::Kelvin, Rheology::StandardSolid, Rheology::Prony}) {
    const Scene scene = withElastomer(rheology);
    const RigidLine rigid(scene);
    const SteadySolver sliding(scene);
    TimeMarch march =
        steadyMarch(rigid, sliding, scene.sliding.velocity, sliding.at(rigid.prepared, 0.2));
    march.record({false, true});
    const double spacing = rigid.line->spacing;
    for (int i = 0; i < 50; ++i) {
      const double distance = (0.2 + 0.05 * i) * spacing, dt = distance / 0.2;
      const MarchStep step = march.step(marchLoad(scene.load, rigid.line->length), dt, distance);
      EXPECT_NEAR(integral(march.power(), spacing) * dt, step.dissipated + step.gapWork,
                  1e-9 * std::abs(step.work) + 1e-25)
          << static_cast<int>(rheology) << " " << i;
    }
  }
}

/// In steady sliding all work is dissipated at any resolution; friction itself is as exact as the
/// march (second order in dx), which is finer than one percent here.
TEST(Power, OfMarchedSteadySlidingIsFrictionTimesVelocity) {
  for (const Rheology rheology : {Rheology::Kelvin, Rheology::Prony}) {
    Scene scene = withElastomer(rheology);
    scene.accuracy.oversampling = 8;
    Simulation simulation(shared(scene), 1);
    simulation.requestFields(kEverything);
    double energy = 0, before = 0;
    while (simulation.frame().distance < scene.surface.length / 2) {
      simulation.singleStep();
      const Frame frame = simulation.frame();
      energy += integral(frame.power, frame.spacing) * (frame.time - before);
      before = frame.time;
    }
    const Frame frame = simulation.frame();
    EXPECT_NEAR(energy / (frame.state.tangentialForce * frame.distance), 1, 0.02)
        << static_cast<int>(rheology);
  }
}

/// Counted step by step, the age of a steady state stays what its positions say.
TEST(SinceContact, IsCountedInTheMarch) {
  const Scene scene = rough();
  Simulation simulation(shared(scene), 1);
  simulation.requestFields(kEverything);
  for (int i = 0; i < 300; ++i) simulation.singleStep();
  const Frame frame = simulation.frame();
  const std::vector<double> steady =
      steadyContactAge(frame.pressure, frame.spacing, scene.sliding.velocity);
  const double each = frame.spacing / scene.sliding.velocity;
  std::size_t apart = 0;  // small contacts come and go from step to step
  for (std::size_t i = 0; i < steady.size(); ++i)
    apart += std::abs(frame.sinceContact[i] - steady[i]) > 3 * each ? 1 : 0;
  EXPECT_LT(apart, steady.size() / 20);
}

TEST(SinceContact, OfAMotionFromRestBeginsWithIt) {
  Scene scene = rough();
  scene.sliding.kind = SlidingKind::Start;
  Simulation simulation(shared(scene), 1);
  simulation.requestFields(kEverything);
  for (const double age : simulation.frame().sinceContact) EXPECT_TRUE(age == 0 || std::isinf(age));
  for (int i = 0; i < 40; ++i) simulation.singleStep();
  const Frame frame = simulation.frame();
  bool someLeft = false;
  for (const double age : frame.sinceContact) {
    EXPECT_TRUE(std::isinf(age) || age <= frame.time * (1 + 1e-12));
    someLeft |= age > 0 && std::isfinite(age);
  }
  EXPECT_TRUE(someLeft);
}

/// Its mean square is the spectrum's, wherever the line stands between two nodes, and it is the
/// derivative of the heights shown.
TEST(LineSlope, IsTheSlopeOfTheHeightsShown) {
  Scene scene = rough();
  scene.accuracy.oversampling = 16;
  Simulation simulation(shared(scene), 1);
  simulation.requestFields(kEverything);
  for (int i = 0; i < 7; ++i) simulation.singleStep();
  const Frame frame = simulation.frame();
  const std::size_t n = frame.lineHeight.size();
  ASSERT_EQ(frame.lineSlope.size(), n);
  double square = 0;
  for (std::size_t i = 0; i < n; ++i) {
    square += frame.lineSlope[i] * frame.lineSlope[i] / static_cast<double>(n);
    const double central =
        (frame.lineHeight[(i + 1) % n] - frame.lineHeight[(i + n - 1) % n]) / (2 * frame.spacing);
    EXPECT_NEAR(frame.lineSlope[i], central, 0.05 * frame.rmsSlope) << i;
  }
  EXPECT_NEAR(std::sqrt(square), frame.rmsSlope, 0.002 * frame.rmsSlope);
}

TEST(Fields, AreEmptyUnlessWanted) {
  Simulation simulation(shared(rough()), 1);
  for (const Frame& frame : {simulation.frame(), SteadyFrames(shared(rough())).frame(0, 1, 25)})
    EXPECT_TRUE(frame.lineSlope.empty() && frame.sinceContact.empty() && frame.power.empty());
  simulation.requestFields(kEverything);
  simulation.singleStep();
  simulation.requestFields({});
  const Frame frame = simulation.frame();
  EXPECT_TRUE(frame.lineSlope.empty() && frame.sinceContact.empty() && frame.power.empty());
}

TEST(Fields, GoOnWithThePresentShapeUnderAnotherScene) {
  Simulation simulation(shared(rough()), 1);
  simulation.requestFields(kEverything);
  for (int i = 0; i < 5; ++i) simulation.singleStep();
  const std::vector<double> before = simulation.frame().sinceContact;
  simulation.update(shared(rough(0.3)), 2);
  EXPECT_EQ(simulation.frame().sinceContact, before);
}

TEST(Fields, ArriveWhileTheRunnerIsPaused) {
  RunnerOptions options;
  options.threads = 1;
  Runner runner(options);
  runner.pause();
  runner.post(rough());
  const auto waitFor = [&](auto&& isThere) {
    while (!runner.newestFrame() || !isThere(*runner.newestFrame())) std::this_thread::yield();
  };
  waitFor([](const Frame& frame) { return frame.power.empty(); });
  runner.requestFields(kEverything);
  waitFor([](const Frame& frame) { return !frame.power.empty(); });
  EXPECT_EQ(runner.newestFrame()->sinceContact.size(), runner.newestFrame()->power.size());
}

constexpr Rheology kRheologies[] = {Rheology::Elastic, Rheology::Kelvin, Rheology::StandardSolid,
                                    Rheology::Prony};

void expectNoPower(const Frame& frame, const std::string& when) {
  for (const double power : frame.power) ASSERT_EQ(power, 0) << when;
}

/// Arms without a dashpot of their own, whose pressures come from the differences of depths.
Scene withArmsAlone(Scene scene) {
  scene.elastomer.viscosity = 0;
  return scene;
}

TEST(SteadyFields, NothingIsDissipatedAtRest) {
  for (const Rheology rheology : kRheologies)
    for (const Scene& scene :
         {withElastomer(rheology, 0), withArmsAlone(withElastomer(rheology, 0))})
      expectNoPower(SteadyFrames(shared(scene), kEverything).frame(0, 1, 25), "");
}

/// Neither in the first frame nor by rounding later, whatever presses; and the elements stay.
TEST(Power, OfAMarchAtRestIsNone) {
  for (const Rheology rheology : kRheologies)
    for (Scene scene : {withElastomer(rheology, 0), withArmsAlone(withElastomer(rheology, 0))})
      for (const LoadKind kind : {LoadKind::Force, LoadKind::Indentation}) {
        scene.load.kind = kind;
        scene.load.depth = 2e-6;
        Simulation simulation(shared(scene), 1);
        simulation.requestFields(kEverything);
        const std::vector<double> begin = simulation.frame().surfaceHeight;
        for (int i = 0; i < 300; ++i) {
          expectNoPower(simulation.frame(), std::to_string(i));
          simulation.singleStep();
        }
        const Frame frame = simulation.frame();
        for (std::size_t i = 0; i < begin.size(); ++i)
          ASSERT_NEAR(frame.surfaceHeight[i], begin[i], 1e-14 * frame.state.indentation);
      }
}

/// What slid relaxes until nothing is left, and rounding is nothing.
TEST(Power, AfterSlidingEndsAtNone) {
  for (const bool armsAlone : {false, true}) {
    Scene sliding = withElastomer(Rheology::StandardSolid, 0.2);
    sliding.elastomer.arms = {{2e7, 1e-4}};
    if (!armsAlone) sliding.elastomer.rheology = Rheology::Kelvin;
    Simulation simulation(shared(sliding), 1);
    simulation.requestFields(kEverything);
    Scene resting = sliding;
    resting.sliding.velocity = 0;
    simulation.update(shared(resting), 2);
    EXPECT_GT(integral(simulation.frame().power, 1), 0);
    for (int i = 0; i < 3000; ++i) simulation.singleStep();
    expectNoPower(simulation.frame(), armsAlone ? "arms" : "Kelvin");
  }
}

TEST(Power, OfAnElasticMarchIsNone) {
  Simulation simulation(shared(withElastomer(Rheology::Elastic)), 1);
  simulation.requestFields(kEverything);
  for (int i = 0; i < 100; ++i) {
    simulation.singleStep();
    expectNoPower(simulation.frame(), std::to_string(i));
  }
}

}  // namespace
}  // namespace asperity
