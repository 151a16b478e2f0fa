#include "ui/window/main/quit_limit.h"

#include <cstdlib>

namespace asperity {

QuitLimit::QuitLimit(std::chrono::milliseconds limit, int status)
    : thread_([this, limit, status] {
        std::unique_lock lock(mutex_);
        if (!changed_.wait_for(lock, limit, [this] { return isOver_; })) std::_Exit(status);
      }) {}

QuitLimit::~QuitLimit() {
  {
    const std::lock_guard lock(mutex_);
    isOver_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

}  // namespace asperity
