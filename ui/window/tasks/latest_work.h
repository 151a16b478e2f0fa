// Does one thing at a time on a thread of its own, the newest that was asked for.
// Threading: the constructor, the destructor (which joins), request() and cancel() on any one
// thread, none of which waits but the destructor; the work runs on the worker's thread and ends
// soon after its token asks it to. What was not begun when something newer came is never begun.
// Failure: the work must not throw.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace asperity {

class LatestWork {
 public:
  using Work = std::function<void(const std::stop_token& stop)>;

  LatestWork();
  ~LatestWork();
  LatestWork(const LatestWork&) = delete;
  LatestWork& operator=(const LatestWork&) = delete;

  void request(Work work);
  void cancel();

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  Work pending_;
  std::stop_source stop_;  // of the newest request
  bool ending_ = false;
  std::thread thread_;  // last: starts when all of the above is there
};

}  // namespace asperity
