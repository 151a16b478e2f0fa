#include "app/pictures/frame_pipeline.h"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace asperity {
namespace {

constexpr std::size_t kWaiting = 3;  // pictures waiting between two stages

template <class Item>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t most) : most_(most) {}

  /// Waits until the queue has a free slot. Returns false where the queue was stopped; the value is
  /// dropped.
  bool put(Item item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || items_.size() < most_; });
    if (stopped_) return false;
    items_.push_back(std::move(item));
    changed_.notify_all();
    return true;
  }

  /// Waits for a value. Returns nothing where no more will come.
  std::optional<Item> take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || ended_ || !items_.empty(); });
    if (stopped_ || items_.empty()) return std::nullopt;
    std::optional<Item> item(std::move(items_.front()));
    items_.pop_front();
    changed_.notify_all();
    return item;
  }

  /// Declares that no more values will be put; the waiting ones can still be taken.
  void end() { set(ended_); }

  /// Stops the queue after a failure: nothing more can be put or taken.
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
  std::deque<Item> items_;
  bool ended_ = false, stopped_ = false;
};

class Pipeline {
 public:
  Pipeline(const std::vector<std::int64_t>& indices, const PipelineStages& stages)
      : indices_(indices), stages_(stages) {}

  StageSeconds run() {
    std::vector<std::jthread> threads;
    threads.emplace_back([this] { guarded([this] { composeAll(); }); });
    for (int i = 0; i < stages_.workers; ++i)
      threads.emplace_back([this] { guarded([this] { sinkAll(); }); });
    guarded([this] { drawAll(); });
    threads.clear();  // waits for all threads
    if (failure_) std::rethrow_exception(failure_);
    return seconds_;
  }

 private:
  struct Composed {
    std::int64_t index;
    DrawList list;
  };
  struct Drawn {
    std::int64_t index;
    QImage image;
  };

  /// Runs a stage. The first failure is kept, and ends all stages.
  template <class Work>
  void guarded(const Work& work) {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      composed_.stop();
      drawn_.stop();
    }
  }

  void add(const StageSeconds& seconds) {
    const std::lock_guard lock(mutex_);
    seconds_.simulate += seconds.simulate;
    seconds_.draw += seconds.draw;
    seconds_.encode += seconds.encode;
    seconds_.write += seconds.write;
  }

  void composeAll() {
    StageSeconds seconds;
    for (const std::int64_t index : indices_) {
      Composed composed{index, {}};
      {
        const StageTimer timer(seconds.simulate);
        composed.list = stages_.compose(index);
      }
      if (!composed_.put(std::move(composed))) return;
    }
    composed_.end();
    add(seconds);
  }

  void drawAll() {
    StageSeconds seconds;
    std::int64_t count = 0;
    while (std::optional<Composed> composed = composed_.take()) {
      Drawn drawn{composed->index, {}};
      {
        const StageTimer timer(seconds.draw);
        drawn.image = stages_.draw(composed->list);
      }
      if (!drawn_.put(std::move(drawn))) return;
      if (stages_.progress) stages_.progress(++count);
    }
    drawn_.end();
    add(seconds);
  }

  void sinkAll() {
    StageSeconds seconds;
    while (const std::optional<Drawn> drawn = drawn_.take())
      stages_.sink(drawn->index, drawn->image, seconds);
    add(seconds);
  }

  const std::vector<std::int64_t>& indices_;
  const PipelineStages& stages_;
  BoundedQueue<Composed> composed_{kWaiting};
  BoundedQueue<Drawn> drawn_{kWaiting};
  std::mutex mutex_;
  std::exception_ptr failure_;
  StageSeconds seconds_;
};

}  // namespace

StageSeconds runPipeline(const std::vector<std::int64_t>& indices, const PipelineStages& stages) {
  return Pipeline(indices, stages).run();
}

}  // namespace asperity
