// Which curve is averaged and what of it is handed on, step by step: no threads, so nothing depends
// on who comes first.
#include "core/run/curve_requests.h"

#include <gtest/gtest.h>

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
  CurvePoint point;
  point.mu = mu;
  point.realizations = done;
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
}  // namespace asperity
