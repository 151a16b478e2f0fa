// Many pictures one after the other, with the stages overlapping: one thread simulates and
// composes, the caller's draws, others encode and write. Between them stand queues of a few
// pictures, so memory does not grow with their number.
// Failure: what any stage throws ends all of them and is thrown on by runPipeline().
#pragma once

#include <QImage>
#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

#include "ui/draw/draw_list.h"

namespace asperity {

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
