// A queue between two stages of a pipeline that holds at most so many things: who is ahead waits,
// so memory stays flat. Any number of threads puts and takes.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

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

}  // namespace asperity
