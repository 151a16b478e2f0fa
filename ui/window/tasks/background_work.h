// Work beside the window: one piece at a time on a thread of its own. Everything that the window
// does in the background goes through this class: opening files, predictions, pictures of diagrams,
// the paper's figures, comparisons, exports. (The simulation itself is no answer to a request but
// goes on and on; it has its own threads in core/run/runner.h.)
//
// Threading: all members are called on the window's thread, and none waits but the destructor. The
// work runs on the worker's thread. What it returns and what it tells arrive on the window's
// thread, and only while they are still wanted: nothing arrives after cancel(), after the
// destructor, or from work that a newer request has overtaken (see Overtaking). Cancelling: the
// work's stop token is set; work should look at it at least every few milliseconds. The destructor
// waits for the work to notice. Where something cannot be asked to stop, the end of the program
// does not wait for it (runUntilClosed in ui/window/main/run_window.h). Failure: an exception of
// the work becomes one translated sentence for `failed`. Work that was stopped throws StudyStopped
// and tells nothing. Ownership: the last member of its owner, so that its thread ends before
// anything else goes.
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

namespace asperity {

/// What a new request does to those before it.
enum class Overtaking {
  StopsTheRunning,  // only the newest answer is of interest
  SkipsTheWaiting,  // what runs is finished and shown: pictures of something that moves
  WaitsForItsTurn,  // every request is carried out: files that are written
};

class BackgroundWork : public QObject {
 public:
  /// Given to the work while it runs, on the worker's thread.
  class Run {
   public:
    const std::stop_token& stop() const { return stop_; }
    /// Calls `tell` on the window's thread if the work is still wanted there.
    void tell(std::function<void()> tell) const;

   private:
    friend class BackgroundWork;
    Run(BackgroundWork& owner, std::uint64_t number, std::stop_token stop)
        : owner_(owner), number_(number), stop_(std::move(stop)) {}

    BackgroundWork& owner_;
    std::uint64_t number_;
    std::stop_token stop_;
  };

  using Failed = std::function<void(const QString& reason)>;

  explicit BackgroundWork(Overtaking overtaking = Overtaking::StopsTheRunning);
  ~BackgroundWork() override;

  /// Computes make(run) on the worker's thread and then calls `take` with the result, if there is
  /// one, on the window's.
  template <class Make, class Take>
  void request(Make make, Take take, Failed failed = {}) {
    using Result = std::invoke_result_t<Make, const Run&>;
    Work work;
    if constexpr (std::is_void_v<Result>) {
      work = [make = std::move(make), take = std::move(take)](const Run& run) {
        make(run);
        run.tell(take);
      };
    } else {
      work = [make = std::move(make), take = std::move(take)](const Run& run) {
        // Shared, because std::function copies what it holds and a result may be large.
        const auto result = std::make_shared<Result>(make(run));
        run.tell([take, result] { take(std::move(*result)); });
      };
    }
    start(std::move(work), std::move(failed));
  }

  /// Stops what runs and forgets what waits; nothing of both arrives any more.
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

  const Overtaking overtaking_;
  std::uint64_t oldestWanted_ = 1, newest_ = 0;  // numbers of requests; the window's thread only
  std::mutex mutex_;                             // of everything down to the thread
  std::condition_variable changed_;
  std::deque<Request> waiting_;
  std::stop_source stop_;
  bool ending_ = false;
  std::thread thread_;  // begins with the first request
};

}  // namespace asperity
