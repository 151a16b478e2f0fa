#include "core/run/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

std::shared_ptr<Scene> someScene() {
  auto scene = std::make_shared<Scene>();
  scene->surface.elements = 200;
  scene->load.normalForce = 0.02;
  scene->sliding.velocity = 1;
  return scene;
}

/// The same in a motion of this duration (s); frequency in Hz.
std::shared_ptr<Scene> movingScene(SlidingKind kind, double duration,
                                   double frequency = Sliding{}.frequency) {
  auto scene = someScene();
  scene->sliding.kind = kind;
  scene->sliding.duration = duration;
  scene->sliding.frequency = frequency;
  return scene;
}

TEST(Simulation, StartsInTheSteadyStateAndStaysThere) {
  auto fine = someScene();
  fine->accuracy.oversampling = 8;
  Simulation simulation(fine, 1);
  const Frame start = simulation.frame();
  EXPECT_EQ(start.time, 0);
  EXPECT_GT(start.state.contactFraction, 0);
  for (int i = 0; i < 50; ++i) simulation.advance(1.0 / 50, 1.0 / 60);
  const Frame later = simulation.frame();
  EXPECT_NEAR(later.distance, 0.02, 1e-12);
  EXPECT_NEAR(later.muMarch / later.state.mu, 1, 0.02);
  EXPECT_NEAR(later.state.indentation / start.state.indentation, 1, 0.01);
}

/// What is pressed far less than before comes back with exp(-t/tau) (Eq. (1) without pressure).
TEST(Simulation, AChangedSceneSettlesAndSaysSo) {
  Simulation simulation(someScene(), 1);
  EXPECT_FALSE(simulation.frame().isSettling);
  auto lighter = someScene();
  lighter->load.normalForce = 1e-5;
  lighter->sliding.velocity = 1e-3;  // slowly: 20 s for a period, 1 ms for an element
  simulation.update(lighter, 2);
  EXPECT_TRUE(simulation.frame().isSettling);
  int frames = 0;
  for (; simulation.frame().isSettling; ++frames) {
    ASSERT_LT(frames, 1000);
    simulation.advance(1.0 / 600, 1.0 / 60);
  }
  EXPECT_GT(frames, 0);
  const Frame settled = simulation.frame();
  double lowest = 0;
  for (const double height : settled.surfaceHeight) lowest = std::min(lowest, height);
  EXPECT_LT(-lowest, 1.03 * settled.state.indentation);
  simulation.update(someScene(), 3);
  EXPECT_TRUE(simulation.frame().isSettling);
  simulation.reset();
  EXPECT_FALSE(simulation.frame().isSettling);
}

/// Force and share in contact that the elements of a frame say.
void expectDrawn(const Frame& frame) {
  double force = 0, touching = 0;
  for (const double pressure : frame.pressure) {
    force += pressure * frame.spacing;
    touching += pressure > 0 ? 1 : 0;
  }
  const double lowest = *std::ranges::min_element(frame.lineHeight);
  EXPECT_NEAR(frame.marched.normalForce, force, 1e-9 * force);  // lifted, it touches nothing
  EXPECT_NEAR(frame.marched.contactFraction, touching / static_cast<double>(frame.pressure.size()),
              1e-12);
  EXPECT_NEAR(frame.marched.indentation / -lowest, 1, 0.01) << "to an element";
}

/// Either of what may be held constant meets its value at once: the other one tells.
TEST(Simulation, WhatIsDrawnWhileItSettlesHasItsOwnFacts) {
  for (const LoadKind kind : {LoadKind::Force, LoadKind::Indentation}) {
    auto scene = someScene();
    scene->accuracy.oversampling = 8;
    scene->load.kind = kind;
    scene->load.depth = 4e-6;
    scene->load.normalForce = 2;
    Simulation simulation(scene, 1);
    simulation.advance(0.1, 1.0 / 60);
    auto other = std::make_shared<Scene>(*scene);
    other->load.normalForce = 0.02;
    other->load.depth = 5e-7;
    other->sliding.velocity = 0.05;
    simulation.update(other, 2);
    simulation.advance(1.0 / 7200, 1.0 / 60);
    int frames = 0;
    for (; simulation.frame().isSettling; ++frames) {
      const Frame frame = simulation.frame();
      ASSERT_LT(frames, 5000);
      expectDrawn(frame);
      if (kind == LoadKind::Indentation) {
        EXPECT_NEAR(frame.marched.indentation, 5e-7, 1e-12);
      }
      simulation.advance(1.0 / 7200, 1.0 / 60);
    }
    EXPECT_GT(frames, 3);
    const Frame settled = simulation.frame();
    double force = 0;
    for (const double pressure : settled.pressure) force += pressure * settled.spacing;
    EXPECT_NEAR(force / settled.state.normalForce, 1, 0.03);
    const double lowest = *std::ranges::min_element(settled.lineHeight);
    EXPECT_NEAR(-lowest / settled.state.indentation, 1, 0.03) << "one truth";
    // It does not begin again by itself.
    for (int i = 0; i < 100; ++i) {
      simulation.advance(1.0 / 720, 1.0 / 60);
      ASSERT_FALSE(simulation.frame().isSettling) << i;
    }
  }
}

/// Contacts of a few elements ripple by more than that, and pass the steady state again and again.
TEST(Simulation, AFewElementsInContactSettleToo) {
  auto scene = someScene();
  scene->surface.elements = 1000;
  scene->load.normalForce = 2e-4;
  Simulation simulation(scene, 1);
  simulation.advance(1.0 / 720, 1.0 / 60);
  auto lighter = std::make_shared<Scene>(*scene);
  lighter->load.normalForce = 1e-4;
  simulation.update(lighter, 2);
  int frames = 0;
  for (; simulation.frame().isSettling; ++frames) simulation.advance(1.0 / 720, 1.0 / 60);
  EXPECT_LT(frames, 300) << "long before the longest memory is over";
}

/// As far as was asked for, however many elements: those of a line of 2^20 could not be marched.
TEST(Simulation, AStepByHandMovesTheLineAsFarAsItIsAskedFor) {
  for (const std::int64_t elements : {200, 5000, 1 << 20})
    for (const double velocity : {0.01, 1.0, 100.0}) {
      if (elements > 5000 && velocity != 1) continue;  // which takes long

      auto scene = someScene();
      scene->surface.elements = elements;
      scene->sliding.velocity = velocity;
      Simulation simulation(scene, 1);
      const double part = 1.0 / 200, length = simulation.frame().length;
      const Frame before = simulation.frame();
      simulation.singleStep(part);
      const Frame after = simulation.frame();
      const double moved = after.distance - before.distance;
      EXPECT_NEAR(moved, part * length, 1.5 * after.spacing) << elements << ' ' << velocity;
      EXPECT_NEAR(after.time - before.time, moved / velocity, 1.5 * after.spacing / velocity);
      EXPECT_GT(after.step, before.step);
      simulation.singleStep();
      EXPECT_LE(simulation.frame().distance - after.distance, 1.001 * after.spacing);
    }
}

TEST(Simulation, AStepByHandOfAMotionIsAsFarAndNoSmallPartOfItIsPassedOver) {
  auto scene = movingScene(SlidingKind::Oscillation, 0.04, 100);
  scene->sliding.velocity = 0;
  scene->sliding.amplitude = 1;
  Simulation simulation(scene, 1);
  const double length = simulation.frame().length;
  int steps = 0;
  for (double last = 0; simulation.frame().time < scene->sliding.duration; ++steps) {
    simulation.singleStep(1.0 / 200);
    const Frame frame = simulation.frame();
    ASSERT_GT(frame.time, last);
    EXPECT_LE(frame.time - last, 0.006 * scene->sliding.duration);
    EXPECT_LE(frame.time - last, 1.5 * length / 200);
    last = frame.time;
  }
  EXPECT_LT(steps, 1000);
  simulation.singleStep(1.0 / 200);
  EXPECT_EQ(simulation.frame().time, 0) << "it begins anew";
}

/// Of the scene, and not of what was before.
TEST(Simulation, TheGreatestPressureOfTheSteadyStateIsKnown) {
  Simulation fresh(someScene(), 1);
  const Frame steady = fresh.frame();
  EXPECT_NEAR(steady.steadyPressure / *std::ranges::max_element(steady.pressure), 1, 1e-12);
  auto heavy = someScene();
  heavy->load.normalForce = 1e30;
  Simulation there(heavy, 1);
  there.advance(0.01, 1.0 / 60);
  there.update(someScene(), 2);
  EXPECT_EQ(there.frame().steadyPressure, steady.steadyPressure);
  there.advance(0.01, 1.0 / 60);
  EXPECT_EQ(there.frame().steadyPressure, steady.steadyPressure);
}

TEST(Simulation, TheSameCallsGiveTheSameFrames) {
  const auto run = [] {
    Simulation simulation(someScene(), 1);
    for (int i = 0; i < 5; ++i) simulation.advance(0.01, 1.0 / 60);
    return simulation.frame();
  };
  const Frame one = run(), two = run();
  EXPECT_EQ(one.surfaceHeight, two.surfaceHeight);
  EXPECT_EQ(one.pressure, two.pressure);
}

/// The frame after so many calls, by way of its time alone.
TEST(Simulation, AMomentOfAMotionIsFoundAgain) {
  constexpr double kPart = 1.0 / 72, kWall = 1.0 / 60;
  for (const SlidingKind kind :
       {SlidingKind::Start, SlidingKind::Step, SlidingKind::Oscillation, SlidingKind::Reversal}) {
    auto scene = movingScene(kind, 0.004, 600);
    Simulation simulation(scene, 1);
    for (const int more : {0, 1, 16, 19, 1, 40}) {
      for (int i = 0; i < more; ++i) simulation.advance(kPart, kWall);
      const Frame frame = simulation.frame();
      for (const double later : {0.0, 0.5}) {
        Simulation again(scene, 1);
        again.advanceTo(frame.time + later * frame.nextStep, kPart, kWall);
        const Frame found = again.frame();
        EXPECT_EQ(found.step, frame.step);
        EXPECT_EQ(found.time, frame.time);
        EXPECT_EQ(found.surfaceHeight, frame.surfaceHeight);
        EXPECT_EQ(found.pressure, frame.pressure);
        ASSERT_EQ(found.transient->size(), frame.transient->size());
        for (std::size_t i = 0; i < found.transient->size(); ++i)
          EXPECT_EQ((*found.transient)[i].indentation, (*frame.transient)[i].indentation);
        if (std::isfinite(frame.state.mu)) {
          EXPECT_EQ(found.state.mu, frame.state.mu);
        }
      }
    }
  }
}

/// A moment is the same state wherever one comes from: forward from the beginning, or back from a
/// later one by way of a state that was kept.
TEST(Simulation, AMomentIsTheSameFromBothSides) {
  constexpr double kPart = 1.0 / 72, kWall = 1.0 / 60;
  for (const SlidingKind kind :
       {SlidingKind::Start, SlidingKind::Step, SlidingKind::Oscillation, SlidingKind::Reversal}) {
    auto scene = movingScene(kind, 0.004, 600);
    const auto goTo = [&](Simulation& simulation, double time) {
      for (int i = 0; i < 1000; ++i)
        if (simulation.seek(time, kPart, kWall)) return simulation.frame();
      ADD_FAILURE() << "never there";
      return simulation.frame();
    };
    Simulation wandering(scene, 1);
    for (const double part : {0.8, 0.3, 0.31, 1.0, 0.05, 0.0, 0.62, 2.0, -1.0}) {
      const double time = part * scene->sliding.duration;
      Simulation direct(scene, 1);
      const Frame there = goTo(direct, time), found = goTo(wandering, time);
      EXPECT_EQ(found.step, there.step) << part;
      EXPECT_EQ(found.time, there.time);
      EXPECT_LE(found.time, std::max(time, 0.0) + 1e-12);
      EXPECT_GE(found.time + found.nextStep, std::min(time, scene->sliding.duration) - 1e-12);
      EXPECT_EQ(found.surfaceHeight, there.surfaceHeight);
      EXPECT_EQ(found.pressure, there.pressure);
      // The history on the way is there, in order and once.
      const auto& samples = *found.transient;
      for (std::size_t i = 1; i < samples.size(); ++i)
        ASSERT_GT(samples[i].time, samples[i - 1].time);
      if (!samples.empty()) {
        EXPECT_EQ(samples.back().time, found.time);
      }
    }
  }
}

/// The contact at the beginning is the one at rest, without friction.
TEST(Simulation, AStartBeginsAtRest) {
  auto scene = movingScene(SlidingKind::Start, 0.004);
  scene->sliding.velocity = 0.5;
  Simulation simulation(scene, 1);
  EXPECT_EQ(simulation.frame().velocity, 0);
  EXPECT_LT(simulation.frame().state.mu, 1e-6);
  simulation.advance(1.0 / 72, 1.0 / 60);
  EXPECT_EQ(simulation.frame().velocity, 0.5);
  EXPECT_GT(simulation.frame().state.mu, 1e-5);
}

TEST(Simulation, SteadySlidingHasNoMoments) {
  Simulation simulation(someScene(), 1);
  simulation.advance(1.0 / 72, 1.0 / 60);
  const double before = simulation.frame().distance;
  EXPECT_TRUE(simulation.seek(0, 1.0 / 72, 1.0 / 60));
  EXPECT_EQ(simulation.frame().distance, before);
}

/// Where the budget of steps binds, a line that becomes faster passes by faster.
TEST(Simulation, AMotionHasOneTimeScale) {
  auto scene = movingScene(SlidingKind::Step, 0.1);
  scene->sliding.velocity = 0.3;
  scene->sliding.velocityAfter = 0.6;
  const std::size_t nodes = Simulation(scene, 1).frame().lineHeight.size();
  Simulation simulation(scene, 1, 8.0 * static_cast<double>(nodes));  // 8 steps a frame
  const double node = simulation.frame().spacing / 0.6;
  double before = 0;
  while (simulation.frame().time < scene->sliding.duration) {
    simulation.advance(1.0 / 50, 1.0 / 60);
    const Frame frame = simulation.frame();
    EXPECT_NEAR(frame.timeScale, 8 * node * 60, 1e-9 * frame.timeScale);
    if (frame.time < scene->sliding.duration) {
      EXPECT_NEAR(frame.time - before, 8 * node, 2 * node);  // whole steps
    }
    before = frame.time;
  }
}

TEST(Simulation, ALiveChangeGoesOnFromThePresentShape) {
  Simulation simulation(someScene(), 1);
  simulation.advance(0.1, 1.0 / 60);
  const Frame before = simulation.frame();
  auto changed = someScene();
  changed->sliding.velocity = 0.01;
  simulation.update(changed, 2);
  EXPECT_EQ(simulation.frame().surfaceHeight, before.surfaceHeight);
  EXPECT_EQ(simulation.frame().sceneNumber, 2U);
  changed = someScene();
  changed->surface.elements = 300;
  simulation.update(changed, 3);
  EXPECT_NE(simulation.frame().surfaceHeight.size(), before.surfaceHeight.size());
}

/// Paused, a new scene is shown as it will be: shape, pressures and facts of one and the same
/// A title, a sweep or a table beside the curve moves nothing.
TEST(Simulation, WhatDoesNotSlideLeavesThePictureAlone) {
  for (const SlidingKind kind : {SlidingKind::Steady, SlidingKind::Oscillation}) {
    auto scene = movingScene(kind, 0.01, 100);
    scene->sliding.amplitude = 0.5;
    Simulation simulation(scene, 1);
    for (int i = 0; i < 7; ++i) simulation.advance(1e-2, 1.0 / 60);
    const Frame before = simulation.frame();
    EXPECT_GT(before.distance, 0);
    auto other = std::make_shared<Scene>(*scene);
    other->title = "Another title";
    other->sweep.points = 7;
    simulation.update(other, 2);
    const Frame after = simulation.frame();
    EXPECT_EQ(after.sceneNumber, 2U);
    EXPECT_EQ(after.scene->title, "Another title");
    EXPECT_EQ(after.time, before.time);
    EXPECT_EQ(after.distance, before.distance);
    EXPECT_EQ(after.lineHeight, before.lineHeight);
    EXPECT_EQ(after.surfaceHeight, before.surfaceHeight);
  }
}

/// state.
TEST(Simulation, AChangeWhilePausedShowsTheNewSteadyState) {
  Simulation simulation(someScene(), 1);
  simulation.advance(0.1, 1.0 / 60);
  auto heavier = someScene();
  heavier->load.normalForce = 2;
  simulation.update(heavier, 2, Simulation::Shape::Steady);
  const Frame frame = simulation.frame();
  EXPECT_NEAR(frame.state.normalForce, 2, 1e-12);
  EXPECT_NEAR(frame.distance, 0.002, 1e-4);  // the line stays where it was, to a node
  EXPECT_EQ(frame.timeScale, 0);
  double force = 0;
  for (std::size_t i = 0; i < frame.pressure.size(); ++i) {
    force += frame.pressure[i] * frame.spacing;
    EXPECT_GE(frame.lineHeight[i] - frame.surfaceHeight[i], -1e-12);
  }
  EXPECT_NEAR(force / 2, 1, 0.02);
}

/// Wedges at rest whose balance once went on for ever.
TEST(Simulation, EndsOnLoadsThatFallOnAThreshold) {
  for (const auto& [elements, force] :
       {std::pair{50, 0.04}, {100, 0.0016}, {100, 0.0256}, {64, 0.25}}) {
    auto scene = std::make_shared<Scene>();
    scene->surface.kind = SurfaceKind::Wedge;
    scene->surface.elements = elements;
    scene->accuracy.oversampling = 1;
    scene->load.normalForce = force;
    scene->sliding.velocity = 0;
    Simulation simulation(scene, 1);
    for (int i = 0; i < 400; ++i) simulation.advance(0.01, 1.0 / 60);
    EXPECT_GT(simulation.frame().time, 0);
  }
}

TEST(Simulation, ASpeedStepRelaxesToTheNewSteadyState) {
  auto scene = someScene();
  scene->accuracy.oversampling = 8;
  Simulation simulation(scene, 1);
  auto slower = someScene();
  slower->accuracy.oversampling = 8;
  slower->sliding.velocity = 0.3;
  simulation.update(slower, 2);
  for (int i = 0; i < 60; ++i) simulation.advance(1.0 / 30, 1.0 / 60);
  const Frame frame = simulation.frame();
  EXPECT_NEAR(frame.muMarch / frame.state.mu, 1, 0.02);
}

TEST(Simulation, FrictionIsNotReadFromStepsTooLongForIt) {
  auto scene = someScene();
  scene->sliding.velocity = 1e-5;  // v tau = 1e-8 m, far below the spacing
  Simulation simulation(scene, 1);
  simulation.advance(0.01, 1.0 / 60);
  EXPECT_TRUE(std::isnan(simulation.frame().muMarch));
  EXPECT_GT(simulation.frame().state.mu, 0);
}

/// On some lines, loads and velocities, settled: what is shown is the steady friction to 10 %, and
/// nothing is where contacts are hardly an element long.
TEST(Simulation, FrictionIsReadOnlyWhereContactsAreResolved) {
  constexpr int kFrames = 20;
  int read = 0, left = 0;
  for (const double force : {1e-6, 0.0034, 0.2})
    for (const double velocity : {0.1, 1.0, 10.0, 300.0})
      for (const int finer : {2, 8}) {
        auto scene = someScene();
        scene->surface.elements = 2000;
        scene->surface.seed = 7;
        scene->accuracy.oversampling = finer;
        scene->load.normalForce = force;
        scene->sliding.velocity = velocity;
        Simulation simulation(scene, 1);
        for (int i = 0; i < kFrames; ++i) {
          simulation.advance(1.0 / 720, 1.0 / 60);
          const Frame frame = simulation.frame();
          if (!std::isfinite(frame.muMarch)) {
            ++left;
            continue;
          }
          ++read;
          EXPECT_NEAR(frame.muMarch / frame.state.mu, 1, 0.1)
              << force << " N, " << velocity << " m/s, " << finer;
        }
      }
  EXPECT_GT(read, 6 * kFrames);
  EXPECT_GT(left, 6 * kFrames);
}

/// What moves in the window is the steady state that its numbers are of: crosshair, power and
/// header agree wherever the line stands.
TEST(Simulation, SettledFramesShowWhatTheirNumbersSay) {
  auto scene = someScene();
  scene->interface.frictionCoefficient = 0.1;
  Simulation simulation(scene, 1);
  simulation.requestFields({true, true, true});
  const double g = scene->elastomer.shearModulus, c = scene->elastomer.relaxationTime;  // at 1 m/s
  std::size_t first = 0;  // where the lowest point was at distance 0
  for (int i = 0; i < 30; ++i) {
    simulation.advance(0.013, 1.0 / 60);
    const Frame frame = simulation.frame();
    ASSERT_FALSE(frame.isSettling);
    const double largest = *std::max_element(frame.pressure.begin(), frame.pressure.end());
    double power = 0;
    for (std::size_t k = 0; k < frame.pressure.size(); ++k) {
      power += frame.power[k] * frame.spacing;
      if (!(frame.pressure[k] > 0)) continue;
      EXPECT_NEAR(frame.pressure[k], 4 * g * (c * frame.lineSlope[k] - frame.surfaceHeight[k]),
                  1e-9 * largest);
      EXPECT_NEAR(frame.lineHeight[k], frame.surfaceHeight[k], 1e-12 * frame.state.indentation);
    }
    // The sum over the points of a line at two points to an element.
    EXPECT_NEAR(power / ((frame.state.mu + 0.1) * frame.state.normalForce), 1, 0.1);
    // The line stands where it has slid to, to a node.
    const auto n = frame.lineHeight.size();
    const auto lowest = std::min_element(frame.lineHeight.begin(), frame.lineHeight.end());
    EXPECT_NEAR(-*lowest, frame.state.indentation, 0.01 * frame.state.indentation);
    const auto at = static_cast<std::size_t>(lowest - frame.lineHeight.begin());
    const auto slid = static_cast<std::size_t>(std::llround(frame.distance / frame.spacing));
    if (i == 0) first = (at + n - slid % n) % n;
    EXPECT_EQ((first + slid) % n, at);
  }
}

/// A change goes on from what was seen, and the march's own state takes no part before it.
TEST(Simulation, AChangeBeginsWithThePictureBeforeIt) {
  Simulation simulation(someScene(), 1);
  for (int i = 0; i < 20; ++i) simulation.advance(0.01, 1.0 / 60);
  const Frame before = simulation.frame();
  auto heavier = someScene();
  heavier->load.normalForce = 0.2;
  simulation.update(heavier, 2);
  const Frame after = simulation.frame();
  EXPECT_TRUE(after.isSettling);
  EXPECT_EQ(after.surfaceHeight, before.surfaceHeight);
  EXPECT_EQ(after.pressure, before.pressure);
}

/// Friction is there from the first frame of a motion on and through rest, with its error.
TEST(Simulation, AMotionThatStopsHasFrictionAtAllTimes) {
  auto scene = movingScene(SlidingKind::Step, 0.004);
  scene->sliding.velocityAfter = 0;
  Simulation simulation(scene, 1);
  EXPECT_GT(simulation.frame().state.mu, 0);
  double sliding = 0, resting = 0;
  while (simulation.frame().time < scene->sliding.duration) {
    simulation.advance(1.0 / 100, 1.0 / 60);
    const Frame frame = simulation.frame();
    ASSERT_TRUE(std::isfinite(frame.state.mu)) << frame.time;
    ASSERT_TRUE(frame.step <= 2 || std::isfinite(frame.muError)) << frame.time;
    (frame.velocity > 0 ? sliding : resting) = frame.state.mu;
    EXPECT_TRUE(frame.velocity > 0 || frame.time > 0.0022 || frame.state.mu > 0.05 * sliding);
  }
  EXPECT_LT(resting, 0.2 * sliding);
}

TEST(Simulation, AtRestTimeGoesOn) {
  auto scene = someScene();
  scene->sliding.velocity = 0;
  Simulation simulation(scene, 1);
  simulation.advance(0.01, 1.0 / 60);
  EXPECT_GT(simulation.frame().time, 0);
  EXPECT_EQ(simulation.frame().distance, 0);
}

TEST(Simulation, AStepAndAResetAreCounted) {
  Simulation simulation(someScene(), 1);
  simulation.singleStep();
  simulation.singleStep();
  EXPECT_EQ(simulation.frame().step, 2U);
  simulation.reset();
  EXPECT_EQ(simulation.frame().step, 0U);
  EXPECT_EQ(simulation.frame().distance, 0);
}

/// A nominal pressure is a force on the period: another line is pressed in by it before it is
/// shown, as by that force.
TEST(Simulation, AnotherLineUnderAPressureIsPressedInByItsForce) {
  const auto pressedIn = [](LoadKind kind) {
    auto scene = someScene();
    const double length = scene->surface.length;
    scene->load.nominalPressure = scene->load.normalForce / (length * length);
    scene->load.kind = kind;
    Simulation simulation(scene, 1);
    for (int i = 0; i < 10; ++i) simulation.advance(1.0 / 50, 1.0 / 60);
    auto other = std::make_shared<Scene>(*scene);
    other->surface.seed += 1;
    simulation.update(other, 2);
    return simulation.frame();
  };
  const Frame force = pressedIn(LoadKind::Force), pressure = pressedIn(LoadKind::Pressure);
  ASSERT_TRUE(pressure.isSettling);
  EXPECT_NEAR(pressure.marched.indentation / force.marched.indentation, 1, 1e-9);
  EXPECT_NEAR(pressure.marched.normalForce / force.marched.normalForce, 1, 1e-9);
}

/// The strips of a motion begin at time 0 and show its extremes, whether few or many frames are
/// shown of it.
TEST(Simulation, TheSamplesOfAMotionDoNotDependOnItsPace) {
  auto scene = movingScene(SlidingKind::Oscillation, 0.06, 50);
  scene->sliding.velocity = 0;
  scene->sliding.amplitude = 0.5;
  struct Extremes {
    double leastSpeed = 1, greatestSpeed = 0, leastMu = 1;
    double longest = 0;  // s, between samples
  };
  const auto run = [&](double part) {
    Simulation simulation(scene, 1);
    while (simulation.frame().time < scene->sliding.duration) simulation.advance(part, 1.0 / 60);
    const Frame last = simulation.frame();
    const std::vector<TransientSample>& samples = *last.transient;
    EXPECT_EQ(samples.front().time, 0);
    EXPECT_EQ(samples.back().time, scene->sliding.duration);
    Extremes found;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      found.longest = std::max(found.longest, samples[i].time - samples[i - 1].time);
      found.leastSpeed = std::min(found.leastSpeed, std::abs(samples[i].velocity));
      found.greatestSpeed = std::max(found.greatestSpeed, std::abs(samples[i].velocity));
      found.leastMu = std::min(found.leastMu, samples[i].mu);
    }
    return found;
  };
  const Extremes slow = run(1.0 / 2000), fast = run(1.0 / 40);
  EXPECT_LT(fast.longest, 2.01 * scene->sliding.duration / 500);
  EXPECT_NEAR(fast.greatestSpeed, slow.greatestSpeed, 0.001);
  EXPECT_NEAR(fast.leastSpeed, slow.leastSpeed, 0.01);
  EXPECT_LT(fast.leastMu, 1.5 * slow.leastMu);
}

/// A pace at which a step of the motion lasts many frames is that of the picture, too.
TEST(Simulation, AMotionMovesAsSlowlyAsWanted) {
  const auto scene = movingScene(SlidingKind::Oscillation, 0.06, 50);
  const double duration = scene->sliding.duration, step = duration / 500, interval = 1.0 / 60;
  constexpr int kFrames = 600;
  for (const double frames : {720.0, 4000.0, 36000.0}) {  // for the whole motion
    Simulation simulation(scene, 1);
    for (int i = 0; i < kFrames; ++i) {
      simulation.advance(1 / frames, interval);
      const Frame frame = simulation.frame();
      EXPECT_NEAR(frame.timeScale, duration / frames / interval, 1e-9 * frame.timeScale);
    }
    EXPECT_NEAR(simulation.frame().time, kFrames / frames * duration, 1.5 * step) << frames;
  }
}

TEST(Simulation, AMotionThatBeginsAtRestBeginsWithoutFriction) {
  auto scene = movingScene(SlidingKind::Oscillation, 0.06, 50);
  scene->sliding.velocity = 0;
  scene->sliding.amplitude = 0.5;
  const Frame frame = Simulation(scene, 1).frame();
  EXPECT_EQ(frame.state.tangentialForce, 0);
  EXPECT_EQ(frame.state.mu, 0);
}

}  // namespace
}  // namespace asperity
