// Predicts what a scene's friction curve will cost, on a thread of its own.
// Threading: the constructor, the destructor (which joins), request() and cancel() on any one
// thread, none of which waits but the destructor; the callback comes on the worker's thread. The
// newest scene wins: work for an older one stops within a pass over a line and tells nothing.
// Failure: one sentence in the answer; the worker goes on.
#pragma once

#include <QString>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <utility>

#include "core/accuracy/prediction.h"
#include "core/base/message.h"
#include "core/scene/scene.h"
#include "ui/window/tasks/latest_work.h"

namespace asperity {

struct PredictionAnswer {
  std::uint64_t number = 0;  // of the request
  std::optional<Prediction> prediction;
  Message reason;  // where there is none
};

class PredictionWorker {
 public:
  explicit PredictionWorker(std::function<void(PredictionAnswer)> answered)
      : answered_(std::move(answered)) {}

  /// Returns the request's number: 1, 2, ...
  std::uint64_t request(Scene scene);
  void cancel() { work_.cancel(); }

 private:
  void answer(const Scene& scene, std::uint64_t number, const std::stop_token& stop) const;

  std::function<void(PredictionAnswer)> answered_;
  std::uint64_t number_ = 0;
  LatestWork work_;  // last: its thread ends before anything else here goes
};

}  // namespace asperity
