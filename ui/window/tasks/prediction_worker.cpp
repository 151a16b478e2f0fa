#include "ui/window/tasks/prediction_worker.h"

#include <exception>
#include <utility>

#include "core/base/input_error.h"
#include "core/friction/study.h"
#include "core/run/motion_accuracy.h"

namespace asperity {

std::uint64_t PredictionWorker::request(Scene scene) {
  const std::uint64_t number = ++number_;
  work_.request([this, scene = std::move(scene), number](const std::stop_token& stop) {
    answer(scene, number, stop);
  });
  return number;
}

void PredictionWorker::answer(const Scene& scene, std::uint64_t number,
                              const std::stop_token& stop) const {
  PredictionAnswer answer{number, std::nullopt, {}};
  try {
    answer.prediction = predictRun(scene, 0, stop);
  } catch (const StudyStopped&) {
    return;
  } catch (const std::exception& error) {
    answer.reason = messageOf(error);
  }
  answered_(std::move(answer));
}

}  // namespace asperity
