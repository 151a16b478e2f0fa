#include "ui/window/prediction_worker.h"

#include <exception>
#include <utility>

#include "core/friction/study.h"
#include "core/scene/effects.h"

namespace asperity {

PredictionWorker::PredictionWorker(std::function<void(PredictionAnswer)> answered)
    : answered_(std::move(answered)), thread_([this] { run(); }) {}

PredictionWorker::~PredictionWorker() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    stop_.request_stop();
  }
  changed_.notify_one();
  thread_.join();
}

std::uint64_t PredictionWorker::request(Scene scene) {
  const std::lock_guard lock(mutex_);
  stop_.request_stop();
  stop_ = std::stop_source();
  pending_ = std::move(scene);
  changed_.notify_one();
  return ++number_;
}

void PredictionWorker::cancel() {
  const std::lock_guard lock(mutex_);
  stop_.request_stop();
  pending_.reset();
}

void PredictionWorker::run() {
  while (true) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ending_ || pending_; });
    if (ending_) return;
    const Scene scene = *std::exchange(pending_, std::nullopt);
    const std::uint64_t number = number_;
    const std::stop_token stop = stop_.get_token();
    lock.unlock();
    answer(scene, number, stop);
  }
}

void PredictionWorker::answer(const Scene& scene, std::uint64_t number,
                              const std::stop_token& stop) const {
  PredictionAnswer answer{number, std::nullopt, {}};
  try {
    needSteadySliding(scene, "a predicted curve");
    answer.prediction = predictCurve(scene, 0, stop);
  } catch (const StudyStopped&) {
    return;
  } catch (const std::exception& error) {
    answer.reason = QString::fromUtf8(error.what());
  }
  answered_(std::move(answer));
}

}  // namespace asperity
