// Background work of the window: one task at a time on a thread of its own. Everything that the
// window does in the background uses this class: opening files, predictions, pictures of diagrams,
// the paper's figures, comparisons, exports. (The simulation is not an answer to a request but runs
// continuously; it has its own threads in core/run/runner.h.)
//
// Threading: all members are called on the window's thread, and only the destructor waits. The work
// runs on the worker's thread. Its result and its progress arrive on the window's thread, and only
// while they are still needed: nothing arrives after cancel(), after the destructor, or from work
// that a newer request has replaced (see RequestPolicy). Cancelling: the work's stop token is set;
// work should check it at least every few milliseconds. The destructor waits for the work to stop.
// Where work cannot be stopped, the end of the program does not wait for it (runUntilClosed in
// ui/window/main/run_window.h). Failure: an exception of the work becomes one sentence, in the
// language of the window, for `failed`. Stopped work throws StopRequested and reports nothing.
// Ownership: it is the last member of its owner, so that its thread ends before other members are
// destroyed.
#pragma once

#include <QObject>
#include <QString>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <type_traits>
#include <utility>

#include "ui/language/language.h"

namespace asperity {

/// The effect of a new request on earlier ones.
enum class RequestPolicy {
  CancelRunning,   // only the newest answer matters
  ReplaceWaiting,  // the running one is finished and shown: pictures of something that moves
  RunInOrder,      // every request is carried out, also at the end: files are written
  RunUntilEnd,     // every request is carried out, but none after the end: pictures of a list
};

class BackgroundWork : public QObject {
 public:
  /// Gives the work access to the window while it runs, on the worker's thread.
  class Run {
   public:
    const std::stop_token& stop() const { return stop_; }
    /// Calls `post` on the window's thread if the work is still needed.
    void post(std::function<void()> post) const;
    /// Returns a function for the part of the work that is done: it posts each new whole percent to
    /// `show`. It must not outlive the work.
    std::function<void(double part)> percents(std::function<void(int percent)> show) const;

   private:
    friend class BackgroundWork;
    void end(std::function<void()> tell) const;
    Run(BackgroundWork& owner, std::uint64_t number, std::stop_token stop)
        : owner_(owner), number_(number), stop_(std::move(stop)) {}

    BackgroundWork& owner_;
    std::uint64_t number_;
    std::stop_token stop_;
  };

  using Failed = std::function<void(const LiveText& reason)>;

  explicit BackgroundWork(RequestPolicy policy = RequestPolicy::CancelRunning);
  ~BackgroundWork() override;

  /// Computes make(run) on the worker's thread and then calls `take` with the result, if there is
  /// one, on the window's thread.
  template <class Make, class Take>
  void request(Make make, Take take, Failed failed = {}) {
    using Result = std::invoke_result_t<Make, const Run&>;
    Work work;
    if constexpr (std::is_void_v<Result>) {
      work = [make = std::move(make), take = std::move(take)](const Run& run) {
        make(run);
        run.end(take);
      };
    } else {
      work = [make = std::move(make), take = std::move(take)](const Run& run) {
        // The pointer is shared, because std::function copies what it holds and a result may be
        // large.
        const auto result = std::make_shared<Result>(make(run));
        run.end([take, result] { take(std::move(*result)); });
      };
    }
    start(std::move(work), std::move(failed));
  }

  /// Returns whether a request is still to be answered. While the newest one is answered, by `take`
  /// or `failed`, none is.
  bool isBusy() const { return ended_ < newest_; }

  /// Stops the running work and drops waiting work; no results of either arrive later.
  void cancel();

 private:
  using Work = std::function<void(const Run& run)>;
  struct Request {
    Work work;
    Failed failed;
    std::uint64_t number = 0;
  };

  void start(Work work, Failed failed);
  void work();
  void carryOut(const Request& request, const std::stop_token& stop);

  const RequestPolicy policy_;
  // Numbers of requests, for the window's thread only: whose answers are needed, that was made
  // last, that has ended.
  std::uint64_t oldestRequest_ = 1, newest_ = 0, ended_ = 0;
  std::mutex mutex_;  // protects everything down to the thread
  std::condition_variable changed_;
  std::deque<Request> waiting_;
  std::stop_source stop_;
  bool ending_ = false;
  std::thread thread_;  // starts with the first request
};

}  // namespace asperity
