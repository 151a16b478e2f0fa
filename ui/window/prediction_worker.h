// Predicts what a scene's friction curve will cost, on a thread of its own.
// Threading: the constructor, the destructor (which joins), request() and cancel() on any one
// thread, none of which waits but the destructor; the callback comes on the worker's thread. The
// newest scene wins: work for an older one stops within a pass over a line and tells nothing.
// Failure: one sentence in the answer; the worker goes on.
#pragma once

#include <QString>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "core/accuracy/prediction.h"
#include "core/scene/scene.h"

namespace asperity {

struct PredictionAnswer {
  std::uint64_t number = 0;  // of the request
  std::optional<Prediction> prediction;
  QString reason;  // where there is none
};

class PredictionWorker {
 public:
  explicit PredictionWorker(std::function<void(PredictionAnswer)> answered);
  ~PredictionWorker();
  PredictionWorker(const PredictionWorker&) = delete;
  PredictionWorker& operator=(const PredictionWorker&) = delete;

  /// Returns the request's number: 1, 2, ...
  std::uint64_t request(Scene scene);
  void cancel();

 private:
  void run();
  void answer(const Scene& scene, std::uint64_t number, const std::stop_token& stop) const;

  std::function<void(PredictionAnswer)> answered_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Scene> pending_;
  std::stop_source stop_;  // of the newest request
  std::uint64_t number_ = 0;
  bool ending_ = false;
  std::thread thread_;  // last: starts when all of the above is there
};

}  // namespace asperity
