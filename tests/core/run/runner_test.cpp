#include "core/run/runner.h"

#include <gmock/gmock.h>

#include <chrono>
#include <functional>
#include <set>
#include <thread>
#include <utility>

#include "core/run/simulation.h"
#include "tests/core/small_scene.h"

namespace asperity {
namespace {

PostedScene posted(std::uint64_t number, double force, double velocity = 1) {
  Scene scene = sceneOfSize(100, 5, 9);
  scene.load.normalForce = force;
  scene.sliding.velocity = velocity;
  return {std::make_shared<const Scene>(scene), number};
}

/// Offers an average over `done` of 9 realizations, all of this coefficient of friction.
bool offer(CurveRequests& orders, std::uint64_t curve, std::int64_t done, double mu) {
  CurvePoint point{.mu = mu, .realizations = done};
  CurveUpdate update;
  update.realizationsDone = done;
  update.realizationsTotal = 9;
  update.points = {point};
  return orders.offer(curve, update);
}

TEST(CurveRequests, AnAverageComesUnderTheNumberOfItsScene) {
  CurveRequests orders;
  EXPECT_FALSE(orders.hasNewerThan(0));
  orders.post(posted(1, 1));
  ASSERT_TRUE(orders.hasNewerThan(0));
  const CurveWork work = orders.begin();
  EXPECT_FALSE(orders.hasNewerThan(work.number));
  EXPECT_EQ(work.scene.number, 1U);
  EXPECT_FALSE(work.stop.stop_requested());
  EXPECT_TRUE(offer(orders, work.number, 1, 0.5));
  const std::vector<CurveUpdate> updates = orders.takeUpdates();
  ASSERT_EQ(updates.size(), 1U);
  EXPECT_EQ(updates.front().sceneNumber, 1U);
  EXPECT_EQ(updates.front().scene, work.scene.scene);
  EXPECT_EQ(updates.front().points.front().mu, 0.5);
  EXPECT_TRUE(orders.takeUpdates().empty());
}

TEST(CurveRequests, AnotherScenesCurveStopsTheOneUnderWay) {
  CurveRequests orders;
  orders.post(posted(1, 1));
  const CurveWork old = orders.begin();
  orders.post(posted(2, 2));
  EXPECT_TRUE(old.stop.stop_requested());
  ASSERT_TRUE(orders.hasNewerThan(old.number));
  const CurveWork next = orders.begin();
  EXPECT_EQ(next.scene.number, 2U);
  EXPECT_FALSE(next.stop.stop_requested());
}

/// A line may be done in the very moment when the next scene is posted.
TEST(CurveRequests, AStaleAverageIsNotOfferedUnderTheNewScenesNumber) {
  CurveRequests orders;
  orders.post(posted(1, 1));
  const CurveWork old = orders.begin();
  orders.post(posted(2, 2));
  EXPECT_FALSE(offer(orders, old.number, 3, 0.5));
  EXPECT_TRUE(orders.takeUpdates().empty());
  const CurveWork next = orders.begin();
  EXPECT_FALSE(offer(orders, old.number, 4, 0.5));
  EXPECT_TRUE(offer(orders, next.number, 1, 0.7));
  orders.post(posted(3, 2, 5));  // the same curve: what is handed over again is its own
  const std::vector<CurveUpdate> updates = orders.takeUpdates();
  ASSERT_EQ(updates.size(), 1U);
  EXPECT_EQ(updates.front().points.front().mu, 0.7);
}

TEST(CurveRequests, UpdatesOfTheLastSceneAreNotKept) {
  CurveRequests orders;
  orders.post(posted(1, 1));
  const CurveWork old = orders.begin();
  EXPECT_TRUE(offer(orders, old.number, 1, 0.5));
  EXPECT_TRUE(offer(orders, old.number, 2, 0.5));
  orders.post(posted(2, 2));
  EXPECT_TRUE(orders.takeUpdates().empty());
}

TEST(CurveRequests, ASceneWithTheSameCurveGetsItUnderItsOwnNumberAndStopsNothing) {
  CurveRequests orders;
  orders.post(posted(1, 1));
  const CurveWork work = orders.begin();
  EXPECT_TRUE(offer(orders, work.number, 1, 0.5));
  EXPECT_TRUE(offer(orders, work.number, 2, 0.6));
  const PostedScene faster = posted(2, 1, 7);
  orders.post(faster);
  EXPECT_FALSE(work.stop.stop_requested());
  EXPECT_FALSE(orders.hasNewerThan(work.number));
  const std::vector<CurveUpdate> updates = orders.takeUpdates();
  ASSERT_EQ(updates.size(), 1U);
  EXPECT_EQ(updates.front().sceneNumber, 2U);
  EXPECT_EQ(updates.front().scene, faster.scene);
  EXPECT_EQ(updates.front().realizationsDone, 2);
  EXPECT_TRUE(offer(orders, work.number, 3, 0.6));
  EXPECT_EQ(orders.takeUpdates().front().sceneNumber, 2U);
}

TEST(CurveRequests, StoppedItStaysAndStartedItBeginsAnew) {
  CurveRequests orders;
  orders.post(posted(1, 1));
  const CurveWork work = orders.begin();
  orders.stop();
  EXPECT_TRUE(work.stop.stop_requested());
  EXPECT_FALSE(orders.hasNewerThan(work.number));
  orders.start();
  ASSERT_TRUE(orders.hasNewerThan(work.number));
  EXPECT_FALSE(offer(orders, work.number, 5, 0.5));
  const CurveWork again = orders.begin();
  EXPECT_EQ(again.scene.number, 1U);
  EXPECT_FALSE(again.stop.stop_requested());
}

TEST(CurveRequests, StoppedBeforeItBeganItIsNotAveraged) {
  CurveRequests orders;
  orders.post(posted(1, 1));
  orders.stop();
  EXPECT_TRUE(orders.begin().stop.stop_requested());
  orders.post(posted(2, 2));
  EXPECT_FALSE(orders.begin().stop.stop_requested());
}

TEST(CurveRequests, AtTheEndNothingIsAveraged) {
  CurveRequests orders;
  orders.post(posted(1, 1));
  const CurveWork work = orders.begin();
  orders.end();
  EXPECT_TRUE(work.stop.stop_requested());
}

}  // namespace

namespace {

using namespace std::chrono_literals;

Scene smallScene() {
  return sceneOfSize(100, 5, 9);
}

/// Polls until the condition holds; a test that waits for ever has failed.
void waitFor(const std::function<bool()>& condition) {
  const auto deadline = std::chrono::steady_clock::now() + 60s;
  while (!condition()) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline);
    std::this_thread::sleep_for(1ms);
  }
}

/// Everything that came for one scene, until its curve is whole.
std::vector<CurveUpdate> curveOf(Runner& runner, std::uint64_t number) {
  std::vector<CurveUpdate> all;
  waitFor([&] {
    for (CurveUpdate& update : runner.takeCurveUpdates())
      if (update.sceneNumber == number) all.push_back(std::move(update));
    return !all.empty() && all.back().isComplete;
  });
  return all;
}

TEST(Runner, APostedSceneComesBackAsFramesAndAWholeCurve) {
  Runner runner;
  EXPECT_EQ(runner.newestFrame(), nullptr);
  const std::uint64_t number = runner.post(smallScene());
  waitFor([&] { return runner.newestFrame() && runner.newestFrame()->time > 0; });
  EXPECT_EQ(runner.newestFrame()->sceneNumber, number);
  const auto updates = curveOf(runner, number);
  ASSERT_FALSE(updates.empty());
  EXPECT_EQ(updates.front().realizationsDone, 1);  // the first curve comes at once
  EXPECT_EQ(updates.back().realizationsDone, 9);
  EXPECT_EQ(updates.back().points.size(), 5U);
  EXPECT_TRUE(runner.takeMessages().empty());
}

TEST(Runner, AStoppedCurveStaysAsFarAsItIsUntilItIsBegunAnew) {
  Runner runner;
  Scene scene = smallScene();
  scene.surface.elements = 5000;
  scene.ensemble.realizations = 1000000;  // never ends
  const std::uint64_t number = runner.post(scene);
  waitFor([&] { return !runner.takeCurveUpdates().empty(); });
  runner.stopCurve();
  const auto present = [&] { return runner.newestFrame() ? runner.newestFrame()->step : 0; };
  const std::uint64_t step = present();
  waitFor([&] { return present() > step + 5; });  // the animation goes on
  runner.takeCurveUpdates();                      // what was under way
  const std::uint64_t later = present();
  waitFor([&] { return present() > later + 5; });
  EXPECT_TRUE(runner.takeCurveUpdates().empty());
  runner.startCurve();
  std::vector<CurveUpdate> updates;
  waitFor([&] {
    updates = runner.takeCurveUpdates();
    return !updates.empty();
  });
  EXPECT_EQ(updates.front().sceneNumber, number);
  EXPECT_EQ(updates.front().realizationsDone, 1);
}

TEST(Runner, ACurveStoppedBeforeItBeganIsNotAveraged) {
  Runner runner;
  runner.post(smallScene());
  runner.stopCurve();
  const std::uint64_t next = runner.post([] {
    Scene scene = smallScene();
    scene.load.normalForce *= 2;
    return scene;
  }());
  EXPECT_EQ(curveOf(runner, next).back().realizationsDone, 9);  // a new one is
}

TEST(Runner, TheNewestSceneWins) {
  Runner runner;
  std::uint64_t last = 0;
  for (int i = 1; i <= 300; ++i) {
    Scene scene = smallScene();
    scene.load.normalForce = 1e-3 * i;
    last = runner.post(scene);
  }
  EXPECT_EQ(last, 300U);
  waitFor([&] { return runner.newestFrame() && runner.newestFrame()->sceneNumber == last; });
  EXPECT_EQ(runner.newestFrame()->scene->load.normalForce, 0.3);
  const auto updates = curveOf(runner, last);
  EXPECT_EQ(updates.back().scene->load.normalForce, 0.3);
}

TEST(Runner, AChangeThatTheCurveDoesNotDependOnKeepsIt) {
  Runner runner;
  curveOf(runner, runner.post(smallScene()));
  Scene faster = smallScene();
  faster.sliding.velocity = 7;
  const auto updates = curveOf(runner, runner.post(faster));
  ASSERT_EQ(updates.size(), 1U);  // handed over again under the new number, not computed
  EXPECT_EQ(updates.front().scene->sliding.velocity, 7);
}

/// Twice the pace is half the slow motion.
TEST(Runner, ThePaceIsTheTimeOnTheScreen) {
  Runner runner;
  Scene scene = smallScene();
  runner.post(scene);
  const auto settled = [&](double pace) {
    runner.setPace(pace);
    const double wanted = scene.surface.length / scene.sliding.velocity / pace;
    waitFor([&] {
      return runner.newestFrame() && std::abs(runner.newestFrame()->timeScale / wanted - 1) < 1e-6;
    });
  };
  settled(12);
  settled(48);
  settled(6);
}

/// The line of a motion, on which its usual pace depends, is known to the runner alone until a
/// frame was made.
TEST(Runner, TheFirstFramesOfAMotionHaveItsUsualPace) {
  Runner runner;
  runner.setPace({});
  Scene scene = smallScene();
  runner.post(scene);
  waitFor([&] { return runner.newestFrame() && runner.newestFrame()->timeScale > 0; });
  scene.sliding.kind = SlidingKind::Step;
  scene.sliding.duration = 0.013;
  const std::uint64_t number = runner.open(scene);
  waitFor([&] {
    const auto frame = runner.newestFrame();
    return frame->sceneNumber == number && frame->timeScale > 0;
  });
  const Frame& first = *runner.newestFrame();
  const double pace = usualPace(scene.sliding, first.spacing);
  EXPECT_NE(pace, kDefaultPace);
  EXPECT_NEAR(scene.sliding.duration / first.timeScale, pace, 1e-6 * pace);
}

/// Of the steps after the jump one and a half take as long as one before it: a frame shows a
/// multiple of two of the ones and of three of the others, instead of one, and one or two in turns.
TEST(UsualPace, IsEvenBeforeAndAfterAJumpOfTheVelocity) {
  Scene scene = smallScene();
  scene.surface.length = 0.02;
  scene.surface.elements = 60;
  scene.sliding.kind = SlidingKind::Step;
  scene.sliding.velocity = 1;
  scene.sliding.velocityAfter = 1.5;
  scene.sliding.duration = 0.1;
  const RunnerOptions options;
  Simulation simulation(std::make_shared<const Scene>(scene), 1);
  const double pace = usualPace(scene.sliding, simulation.spacing());
  EXPECT_NEAR(pace, kDefaultPace, 0.6 * kDefaultPace);
  std::set<std::uint64_t> stepsBefore, stepsAfter;
  std::uint64_t last = 0;
  for (int frame = 0; simulation.frame().time < 0.9 * scene.sliding.duration; ++frame) {
    simulation.advance(options.secondsPerFrame() / pace, options.secondsPerFrame());
    const Frame now = simulation.frame();
    const std::uint64_t steps = now.step - std::exchange(last, now.step);
    if (frame < 2) continue;  // rounding may delay the first one
    if (now.time < 0.49 * scene.sliding.duration) stepsBefore.insert(steps);
    if (now.time > 0.51 * scene.sliding.duration) stepsAfter.insert(steps);
  }
  ASSERT_THAT(stepsBefore, testing::SizeIs(1));
  ASSERT_THAT(stepsAfter, testing::SizeIs(1));
  EXPECT_EQ(2 * *stepsAfter.begin(), 3 * *stepsBefore.begin());
}

TEST(Runner, AMomentIsFoundForwardAndBackWhilePaused) {
  Runner runner;
  runner.pause();
  Scene scene = smallScene();
  scene.sliding.kind = SlidingKind::Step;
  scene.sliding.duration = 0.01;
  runner.post(scene);
  for (const double part : {0.6, 0.2, 0.9, 0.0}) {
    const double time = part * scene.sliding.duration;
    runner.seek(time);
    waitFor([&] {
      const auto frame = runner.newestFrame();
      return frame && frame->time <= time + 1e-12 && frame->time + frame->nextStep >= time - 1e-12;
    });
  }
  const std::uint64_t step = runner.newestFrame()->step;
  runner.requestFields({true, false, false});  // one more frame, at the same moment
  waitFor([&] { return !runner.newestFrame()->lineSlope.empty(); });
  EXPECT_EQ(runner.newestFrame()->step, step);
}

TEST(Runner, PausedItMakesFramesOnlyWhenAsked) {
  Runner runner;
  runner.pause();
  EXPECT_FALSE(runner.isPlaying());
  runner.post(smallScene());
  waitFor([&] { return runner.newestFrame() != nullptr; });
  EXPECT_EQ(runner.newestFrame()->step, 0U);
  for (std::uint64_t step = 1; step <= 3; ++step) {
    runner.singleStep();
    waitFor([&] { return runner.newestFrame()->step == step; });
  }
  runner.reset();
  waitFor([&] { return runner.newestFrame()->step == 0; });
  runner.play();
  waitFor([&] { return runner.newestFrame()->step > 3; });
}

/// The next scene of one document goes on; one that was opened has its own beginning.
TEST(Runner, AnOpenedSceneBeginsAtTimeZero) {
  Runner runner;
  runner.pause();
  runner.post(smallScene());
  for (std::uint64_t step = 1; step <= 3; ++step) {
    runner.singleStep();
    waitFor([&] { return runner.newestFrame() && runner.newestFrame()->step == step; });
  }
  Scene next = smallScene();
  next.load.normalForce *= 2;
  const std::uint64_t posted = runner.post(next);
  waitFor([&] { return runner.newestFrame()->sceneNumber == posted; });
  EXPECT_GT(runner.newestFrame()->time, 0);
  const std::uint64_t opened = runner.open(smallScene());
  waitFor([&] { return runner.newestFrame()->sceneNumber == opened; });
  EXPECT_EQ(runner.newestFrame()->time, 0);
  EXPECT_EQ(runner.newestFrame()->distance, 0);
  EXPECT_EQ(runner.newestFrame()->step, 0U);
}

TEST(Runner, ASceneThatCannotRunIsAMessageAndTheNextOneRuns) {
  Runner runner;
  const std::uint64_t good = runner.post(smallScene());
  waitFor([&] { return runner.newestFrame() != nullptr; });
  Scene bad = smallScene();
  bad.surface.kind = SurfaceKind::Sine;
  bad.surface.waves = 100;
  runner.post(bad);
  std::vector<RunnerMessage> messages;
  waitFor([&] {
    for (RunnerMessage& message : runner.takeMessages()) messages.push_back(std::move(message));
    return !messages.empty();
  });
  EXPECT_EQ(messages.front().key, "surface.waves");
  EXPECT_EQ(runner.newestFrame()->sceneNumber, good);
  const std::uint64_t next = runner.post(smallScene());
  waitFor([&] { return runner.newestFrame()->sceneNumber == next; });
}

/// Whatever the reports on the way say of their numbers, a random line asks for more of them and a
/// single one reports nothing before its end.
TEST(Runner, ACurveToATargetBecomesCompleteOnce) {
  for (const SurfaceKind kind : {SurfaceKind::SelfAffine, SurfaceKind::Sine}) {
    Runner runner;
    Scene scene = smallScene();
    scene.surface.kind = kind;
    scene.accuracy.targetRelativeError = 0.02;
    const auto updates = curveOf(runner, runner.post(scene));
    ASSERT_FALSE(updates.empty());
    for (std::size_t i = 0; i + 1 < updates.size(); ++i) EXPECT_FALSE(updates[i].isComplete) << i;
    const CurveUpdate& whole = updates.back();
    EXPECT_EQ(whole.realizationsDone, whole.realizationsTotal);
    ASSERT_EQ(whole.points.size(), 5U);
    for (const CurvePoint& point : whole.points) {
      EXPECT_LT(point.muHigh - point.muLow, 0.2 * point.mu);
      EXPECT_LE(point.realizations, whole.realizationsTotal);
    }
    Scene faster = scene;
    faster.sliding.velocity = 7;  // the same curve, handed over again
    const auto again = curveOf(runner, runner.post(faster));
    ASSERT_EQ(again.size(), 1U);
    EXPECT_EQ(again.front().realizationsDone, whole.realizationsDone);
  }
}

/// Orders are obeyed one after the other: an answer to one shows that nothing else has happened
/// since. So many frames a second that any turn of the runner would make one.
TEST(Runner, UnseenItStandsStillAndItsCurveGoesOn) {
  RunnerOptions options{.framesPerSecond = 1e6, .secondsPerPeriod = 1e-3};
  Runner runner(options);
  const std::uint64_t number = runner.post(smallScene());
  waitFor([&] { return runner.newestFrame() && runner.newestFrame()->step > 3; });
  runner.setVisible(false);
  EXPECT_TRUE(runner.isPlaying());
  const auto answer = [&](bool slopes) {
    FrameFields fields;
    fields.lineSlope = slopes;
    runner.requestFields(fields);
    waitFor([&] { return runner.newestFrame()->lineSlope.empty() != slopes; });
    return runner.newestFrame()->step;
  };
  const std::uint64_t step = answer(true);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(answer(i % 2 != 0), step) << i;
  EXPECT_TRUE(curveOf(runner, number).back().isComplete);
  Scene heavier = smallScene();
  heavier.load.normalForce *= 2;
  const std::uint64_t next = runner.post(heavier);  // is there when somebody looks again
  waitFor([&] { return runner.newestFrame()->sceneNumber == next; });
  EXPECT_FALSE(runner.newestFrame()->isSettling);
  EXPECT_EQ(runner.newestFrame()->step, step);
  EXPECT_TRUE(curveOf(runner, next).back().isComplete);
  runner.setVisible(true);
  waitFor([&] { return runner.newestFrame()->step > step + 3; });
}

TEST(Runner, EndsAtOnceInTheMiddleOfWork) {
  Scene large;
  large.surface.elements = 20000;
  for (int i = 0; i < 3; ++i) {
    Runner runner;
    runner.post(large);
  }
}

}  // namespace
}  // namespace asperity
