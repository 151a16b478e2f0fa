#include "core/run/curve_requests.h"

#include <utility>

#include "core/scene/sweep.h"

namespace asperity {

void CurveRequests::post(const PostedScene& scene) {
  const bool isSame = requested_.scene &&
                      canonicalCurveScene(*scene.scene) == canonicalCurveScene(*requested_.scene);
  present_ = scene;
  updates_.clear();
  if (!isSame) {
    requested_ = scene;
    last_.reset();
    start();
  } else if (last_) {
    last_->scene = scene.scene;
    last_->sceneNumber = scene.number;
    updates_.push_back(*last_);
  }
}

void CurveRequests::stop() {
  isStopped_ = true;
  working_.request_stop();
}

void CurveRequests::start() {
  working_.request_stop();
  isStopped_ = false;
  ++number_;
}

CurveWork CurveRequests::begin() {
  working_ = std::stop_source();
  if (isStopped_) working_.request_stop();
  return {requested_, number_, working_.get_token()};
}

bool CurveRequests::offer(std::uint64_t number, const CurveUpdate& update) {
  if (number != number_) return false;
  last_ = update;
  last_->scene = present_.scene;
  last_->sceneNumber = present_.number;
  updates_.push_back(*last_);
  return true;
}

std::vector<CurveUpdate> CurveRequests::takeUpdates() {
  return std::exchange(updates_, {});
}

}  // namespace asperity
