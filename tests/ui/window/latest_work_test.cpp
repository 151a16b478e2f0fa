// The newest work wins, what is running is asked to stop, and what never began never begins.
#include "ui/window/tasks/latest_work.h"

#include <gtest/gtest.h>

#include <future>
#include <vector>

namespace asperity {
namespace {

TEST(LatestWork, TheNewestWinsAndTheRunningIsAskedToStop) {
  std::promise<void> begun, ended;
  std::vector<int> done;
  {
    LatestWork worker;
    worker.request([&](const std::stop_token& stop) {
      begun.set_value();
      while (!stop.stop_requested()) std::this_thread::yield();
      done.push_back(1);
    });
    begun.get_future().wait();
    worker.request([&](const std::stop_token&) { done.push_back(2); });
    // The first one may have noticed already, and the second be running: only the last is sure.
    worker.request([&](const std::stop_token&) {
      done.push_back(3);
      ended.set_value();
    });
    ended.get_future().wait();
  }
  EXPECT_EQ(done.front(), 1);
  EXPECT_EQ(done.back(), 3);
}

TEST(LatestWork, CancelledWorkStopsAndTheThreadEnds) {
  std::promise<void> begun;
  bool wasStopped = false;
  {
    LatestWork worker;
    worker.request([&](const std::stop_token& stop) {
      begun.set_value();
      while (!stop.stop_requested()) std::this_thread::yield();
      wasStopped = true;
    });
    begun.get_future().wait();
    worker.cancel();
  }
  EXPECT_TRUE(wasStopped);
}

}  // namespace
}  // namespace asperity
