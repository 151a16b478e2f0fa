// Makes many pictures one after the other in overlapping stages: one thread simulates and composes,
// the caller's thread draws, others encode and write. Queues of a few pictures connect the stages,
// so the memory does not grow with the number of pictures.
// Failure: what any stage throws ends all of them; runPipeline() throws it again.
#pragma once

#include <QImage>
#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

#include "ui/draw/draw_list.h"

namespace asperity {

/// Busy time of each stage in seconds, summed over its threads.
struct StageSeconds {
  double simulate = 0, draw = 0, encode = 0, write = 0;
};

struct PipelineStages {
  /// Runs on a thread of its own, in order.
  std::function<DrawList(std::int64_t index)> compose;
  /// Runs on the caller's thread, in order.
  std::function<QImage(const DrawList& list)> draw;
  /// Encodes and writes a picture, and adds the times of both; in order where there is one worker.
  std::function<void(std::int64_t index, const QImage& image, StageSeconds& seconds)> sink;
  int workers = 1;  // threads that call sink
  /// Runs on the caller's thread, after each picture is drawn.
  std::function<void(std::int64_t drawn)> progress;
};

/// Makes the pictures with these numbers. Returns the busy times.
StageSeconds runPipeline(const std::vector<std::int64_t>& indices, const PipelineStages& stages);

/// Adds the seconds of its lifetime to a sum.
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
