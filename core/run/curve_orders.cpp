#include "core/run/curve_orders.h"

#include <utility>

#include "core/scene/sweep.h"

namespace asperity {
void CurveOrders::post(const PostedScene& scene) {
  const bool isSame = ordered_.scene && sceneOfCurve(*scene.scene) == sceneOfCurve(*ordered_.scene);
  present_ = scene;
  updates_.clear();
  if (!isSame) {
    ordered_ = scene;
    last_.reset();
    order();
  } else if (last_) {
    last_->scene = scene.scene;
    last_->sceneNumber = scene.number;
    updates_.push_back(*last_);
  }
}

void CurveOrders::stop() {
  isStopped_ = true;
  working_.request_stop();
}

void CurveOrders::start() {
  order();
}

void CurveOrders::order() {
  working_.request_stop();
  isStopped_ = false;
  ++number_;
}

CurveWork CurveOrders::begin() {
  working_ = std::stop_source();
  if (isStopped_) working_.request_stop();
  return {ordered_, number_, working_.get_token()};
}

bool CurveOrders::offer(std::uint64_t number, const CurveUpdate& update) {
  if (number != number_) return false;
  last_ = update;
  last_->scene = present_.scene;
  last_->sceneNumber = present_.number;
  updates_.push_back(*last_);
  return true;
}

std::vector<CurveUpdate> CurveOrders::takeUpdates() {
  return std::exchange(updates_, {});
}

}  // namespace asperity
