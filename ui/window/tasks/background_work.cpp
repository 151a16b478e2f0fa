#include "ui/window/tasks/background_work.h"

#include <exception>

#include "core/base/input_error.h"
#include "core/base/stop.h"
#include "ui/language/translated.h"
#include "ui/panels/parameter_text.h"

namespace asperity {

namespace {

LiveText reasonOf(const std::exception& error) {
  const auto* input = dynamic_cast<const InputError*>(&error);
  if (!input) return liveError(error);
  return [error = *input] { return errorWithLabel(error); };
}

}  // namespace

BackgroundWork::BackgroundWork(RequestPolicy policy) : policy_(policy) {}

BackgroundWork::~BackgroundWork() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    stop_.request_stop();
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void BackgroundWork::start(Work work, Failed failed) {
  ++newest_;
  if (policy_ == RequestPolicy::CancelRunning) oldestRequest_ = newest_;
  {
    const std::lock_guard lock(mutex_);
    if (policy_ == RequestPolicy::ReplaceWaiting) waiting_.clear();
    if (policy_ == RequestPolicy::CancelRunning) {
      waiting_.clear();
      stop_.request_stop();
      stop_ = std::stop_source();
    }
    waiting_.push_back({std::move(work), std::move(failed), newest_});
  }
  if (!thread_.joinable()) thread_ = std::thread([this] { this->work(); });
  changed_.notify_one();
}

void BackgroundWork::cancel() {
  oldestRequest_ = newest_ + 1;
  ended_ = newest_;
  const std::lock_guard lock(mutex_);
  waiting_.clear();
  stop_.request_stop();
  stop_ = std::stop_source();
}

void BackgroundWork::work() {
  while (true) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
    // Requested files are written before the end.
    const bool hasQueuedRequests = policy_ == RequestPolicy::RunInOrder && !waiting_.empty();
    if (ending_ && !hasQueuedRequests) return;
    const Request request = std::move(waiting_.front());
    waiting_.pop_front();
    const std::stop_token stop = stop_.get_token();
    lock.unlock();
    carryOut(request, stop);
  }
}

void BackgroundWork::carryOut(const Request& request, const std::stop_token& stop) {
  const Run run(*this, request.number, stop);
  try {
    request.work(run);
  } catch (const StopRequested&) {
    run.end([] {});
  } catch (const std::exception& error) {
    run.end([failed = request.failed, reason = reasonOf(error)] {
      if (failed) failed(reason);
    });
  }
}

/// Posts the call to the owner; Qt drops posted calls when their object is destroyed.
void BackgroundWork::Run::post(std::function<void()> post) const {
  QMetaObject::invokeMethod(
      &owner_,
      [owner = &owner_, number = number_, post = std::move(post)] {
        if (number >= owner->oldestRequest_) post();
      },
      Qt::QueuedConnection);
}

/// Posts the answer to the request, which has ended then.
void BackgroundWork::Run::end(std::function<void()> tell) const {
  post([owner = &owner_, number = number_, tell = std::move(tell)] {
    owner->ended_ = number;
    tell();
  });
}

std::function<void(double)> BackgroundWork::Run::percents(
    std::function<void(int percent)> show) const {
  return [this, show = std::move(show), last = 0](double part) mutable {
    const int percent = static_cast<int>(100 * part);
    if (percent != std::exchange(last, percent)) post([show, percent] { show(percent); });
  };
}

}  // namespace asperity
