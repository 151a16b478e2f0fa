#include "app/pictures/frame_pipeline.h"

#include <exception>
#include <mutex>
#include <thread>

namespace asperity {
namespace {

constexpr std::size_t kWaiting = 3;  // pictures waiting between two stages

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
