// Many pictures one after the other, with the stages overlapping: one thread simulates and
// composes, the caller's draws, others encode and write. Between them stand queues of a few
// pictures, so memory does not grow with their number.
// Failure: what any stage throws ends all of them and is thrown on by runPipeline().
#pragma once

#include <QImage>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "ui/draw/draw_list.h"

namespace asperity {

template <class Thing>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t most) : most_(most) {}

  /// Waits for room. False where the queue was stopped: the thing is dropped.
  bool put(Thing thing) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || things_.size() < most_; });
    if (stopped_) return false;
    things_.push_back(std::move(thing));
    changed_.notify_all();
    return true;
  }

  /// Waits for a thing. Nothing where no more will come.
  std::optional<Thing> take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || ended_ || !things_.empty(); });
    if (stopped_ || things_.empty()) return std::nullopt;
    std::optional<Thing> thing(std::move(things_.front()));
    things_.pop_front();
    changed_.notify_all();
    return thing;
  }

  /// No more will be put; what is there is still taken.
  void end() { set(ended_); }

  /// Nothing more is put or taken: somebody failed.
  void stop() { set(stopped_); }

 private:
  void set(bool& flag) {
    const std::lock_guard lock(mutex_);
    flag = true;
    changed_.notify_all();
  }

  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Thing> things_;
  bool ended_ = false, stopped_ = false;
};

/// Busy seconds of each stage, all its threads together.
struct StageSeconds {
  double simulate = 0, draw = 0, encode = 0, write = 0;
};

struct PipelineStages {
  /// On a thread of its own, in order.
  std::function<DrawList(std::int64_t index)> compose;
  /// On the caller's thread, in order.
  std::function<QImage(const DrawList& list)> draw;
  /// Encodes and writes, and adds the times of both; in order where there is one worker.
  std::function<void(std::int64_t index, const QImage& image, StageSeconds& seconds)> sink;
  int workers = 1;  // threads that call sink
  /// On the caller's thread, after each picture is drawn.
  std::function<void(std::int64_t drawn)> progress;
};

/// The pictures with these numbers.
StageSeconds runPipeline(const std::vector<std::int64_t>& indices, const PipelineStages& stages);

/// Adds the seconds of its life.
class StageTimer {
 public:
  explicit StageTimer(double& seconds) : seconds_(seconds) {}
  ~StageTimer() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace asperity
