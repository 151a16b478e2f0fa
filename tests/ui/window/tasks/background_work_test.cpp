// Work in the background: what a newer request does to older ones, cancelling, failures, and that
// everything arrives on the thread of the window.
#include "ui/window/tasks/background_work.h"
#include "core/base/stop.h"

#include <gtest/gtest.h>

#include <QTest>
#include <future>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/ui/window/qt_application.h"

namespace asperity {
namespace {

constexpr int kPatience = 20000;  // ms, far more than anything here takes

void waitForStop(const BackgroundWork::Run& run) {
  while (!run.stop().stop_requested()) std::this_thread::yield();
}

TEST(BackgroundWork, TheResultArrivesOnTheThreadThatAsked) {
  BackgroundWork work;
  std::thread::id worker;
  std::string result;
  work.request(
      [](const BackgroundWork::Run&) {
        return std::pair(std::this_thread::get_id(), std::string("done"));
      },
      [&](const std::pair<std::thread::id, std::string>& made) {
        EXPECT_EQ(QThread::currentThread(), qApp->thread());
        worker = made.first;
        result = made.second;
      });
  ASSERT_TRUE(QTest::qWaitFor([&] { return result == "done"; }, kPatience));
  EXPECT_NE(worker, std::this_thread::get_id());
}

TEST(BackgroundWork, TheNewestWinsAndTheRunningIsAskedToStop) {
  std::promise<void> begun;
  std::vector<int> done, taken;
  BackgroundWork work;
  work.request(
      [&](const BackgroundWork::Run& run) {
        begun.set_value();
        waitForStop(run);
        done.push_back(1);
        return 1;
      },
      [&](int number) { taken.push_back(number); });
  begun.get_future().wait();
  for (const int number : {2, 3})
    work.request(
        [&done, number](const BackgroundWork::Run&) {
          done.push_back(number);
          return number;
        },
        [&](int made) { taken.push_back(made); });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !taken.empty(); }, kPatience));
  EXPECT_EQ(taken, std::vector{3});  // what was overtaken does not arrive
  EXPECT_EQ(done.front(), 1);
  EXPECT_EQ(done.back(), 3);
}

TEST(BackgroundWork, PicturesThatAreOvertakenAreFinishedAndShown) {
  std::promise<void> begun, go;
  std::vector<int> taken;
  BackgroundWork work(RequestPolicy::ReplaceWaiting);
  work.request(
      [&](const BackgroundWork::Run& run) {
        begun.set_value();
        go.get_future().wait();
        EXPECT_FALSE(run.stop().stop_requested());
        return 1;
      },
      [&](int number) { taken.push_back(number); });
  begun.get_future().wait();
  for (const int number : {2, 3})
    work.request([number](const BackgroundWork::Run&) { return number; },
                 [&](int made) { taken.push_back(made); });
  go.set_value();
  ASSERT_TRUE(QTest::qWaitFor([&] { return taken.size() == 2; }, kPatience));
  EXPECT_EQ(taken, (std::vector{1, 3}));
}

TEST(BackgroundWork, EveryFileIsWrittenEvenAtTheEnd) {
  std::vector<int> done;
  {
    BackgroundWork work(RequestPolicy::RunInOrder);
    for (const int number : {1, 2, 3})
      work.request([&done, number](const BackgroundWork::Run&) { done.push_back(number); }, [] {});
  }
  EXPECT_EQ(done, (std::vector{1, 2, 3}));
}

TEST(BackgroundWork, AListIsWorkedOffInOrderAndDroppedAtTheEnd) {
  std::promise<void> begun;
  std::vector<int> done, taken;
  {
    BackgroundWork work(RequestPolicy::RunUntilEnd);
    for (const int number : {1, 2})
      work.request([number](const BackgroundWork::Run&) { return number; },
                   [&](int made) { taken.push_back(made); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !work.isBusy(); }, kPatience));
    EXPECT_EQ(taken, (std::vector{1, 2}));
    work.request(
        [&](const BackgroundWork::Run& run) {
          begun.set_value();
          waitForStop(run);
          done.push_back(3);
        },
        [] {});
    work.request([&](const BackgroundWork::Run&) { done.push_back(4); }, [] {});
    begun.get_future().wait();
  }
  EXPECT_EQ(done, std::vector{3});
}

TEST(BackgroundWork, IsBusyUntilTheNewestRequestIsAnsweredOrCancelled) {
  BackgroundWork work;
  EXPECT_FALSE(work.isBusy());
  std::vector<bool> whenTold;
  const auto tell = [&] { whenTold.push_back(work.isBusy()); };
  const auto waitUntilIdle = [&] {
    EXPECT_TRUE(work.isBusy());
    return QTest::qWaitFor([&] { return !work.isBusy(); }, kPatience);
  };
  work.request([&](const BackgroundWork::Run& run) { run.post(tell); }, tell);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_EQ(whenTold, (std::vector{true, false}));
  work.request([](const BackgroundWork::Run&) { throw std::runtime_error("no"); }, tell,
               [&](const QString&) { tell(); });
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_EQ(whenTold, (std::vector{true, false, false}));
  work.request([](const BackgroundWork::Run&) { throw StopRequested{}; }, tell);
  ASSERT_TRUE(waitUntilIdle());
  work.request([](const BackgroundWork::Run& run) { waitForStop(run); }, tell);
  EXPECT_TRUE(work.isBusy());
  work.cancel();
  EXPECT_FALSE(work.isBusy());
  EXPECT_EQ(whenTold.size(), 3U);
}

TEST(BackgroundWork, WhatWasCancelledTellsNothingAndTheNextGoesOn) {
  std::promise<void> begun;
  int told = 0, taken = 0;
  BackgroundWork work;
  work.request(
      [&](const BackgroundWork::Run& run) {
        run.post([&] { ++told; });
        begun.set_value();
        waitForStop(run);
        run.post([&] { ++told; });
      },
      [&] { ++told; }, [&](const QString&) { ++told; });
  begun.get_future().wait();
  work.cancel();
  work.request([](const BackgroundWork::Run&) {}, [&] { ++taken; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return taken == 1; }, kPatience));
  EXPECT_EQ(told, 0);
}

TEST(BackgroundWork, ItTellsHowFarItIs) {
  std::vector<int> parts;
  bool isDone = false;
  BackgroundWork work;
  work.request(
      [&](const BackgroundWork::Run& run) {
        for (const int part : {1, 2, 3}) run.post([&parts, part] { parts.push_back(part); });
      },
      [&] { isDone = true; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return isDone; }, kPatience));
  EXPECT_EQ(parts, (std::vector{1, 2, 3}));
}

TEST(BackgroundWork, AFailureIsOneSentenceAndTheThreadGoesOn) {
  QString reason;
  int taken = 0;
  BackgroundWork work;
  work.request(
      [](const BackgroundWork::Run&) -> int { throw std::runtime_error("the disk is full"); },
      [&](int) { ++taken; }, [&](const QString& why) { reason = why; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !reason.isEmpty(); }, kPatience));
  EXPECT_EQ(reason, "the disk is full");
  EXPECT_EQ(taken, 0);
  work.request([](const BackgroundWork::Run&) { return 5; }, [&](int number) { taken = number; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return taken == 5; }, kPatience));
}

TEST(BackgroundWork, WorkThatWasStoppedIsNoFailure) {
  int told = 0;
  bool isDone = false;
  BackgroundWork work(RequestPolicy::RunInOrder);
  work.request([](const BackgroundWork::Run&) { throw StopRequested{}; }, [&] { ++told; },
               [&](const QString&) { ++told; });
  work.request([](const BackgroundWork::Run&) {}, [&] { isDone = true; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return isDone; }, kPatience));
  EXPECT_EQ(told, 0);
}

TEST(BackgroundWork, TheEndAsksTheRunningToStopAndNothingArrivesAfterIt) {
  std::promise<void> begun;
  bool wasStopped = false;
  int told = 0;
  {
    BackgroundWork work;
    work.request(
        [&](const BackgroundWork::Run& run) {
          begun.set_value();
          waitForStop(run);
          wasStopped = true;
        },
        [&] { ++told; });
    begun.get_future().wait();
  }
  EXPECT_TRUE(wasStopped);
  QTest::qWait(1);
  EXPECT_EQ(told, 0);
}

}  // namespace
}  // namespace asperity
