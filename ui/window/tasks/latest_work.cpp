#include "ui/window/tasks/latest_work.h"

#include <utility>

namespace asperity {

LatestWork::LatestWork() : thread_([this] { run(); }) {}

LatestWork::~LatestWork() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    stop_.request_stop();
  }
  changed_.notify_one();
  thread_.join();
}

void LatestWork::request(Work work) {
  const std::lock_guard lock(mutex_);
  stop_.request_stop();
  stop_ = std::stop_source();
  pending_ = std::move(work);
  changed_.notify_one();
}

void LatestWork::cancel() {
  const std::lock_guard lock(mutex_);
  stop_.request_stop();
  pending_ = nullptr;
}

void LatestWork::run() {
  while (true) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ending_ || pending_; });
    if (ending_) return;
    const Work work = std::exchange(pending_, nullptr);
    const std::stop_token stop = stop_.get_token();
    lock.unlock();
    work(stop);
  }
}

}  // namespace asperity
