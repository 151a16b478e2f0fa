#include "app/python/call.h"

#include <pthread.h>

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/input_error.h"

namespace asperity {
namespace {

namespace py = pybind11;
using std::chrono::milliseconds;

/// The interval of the checks for Ctrl+C and of progress reports, and the time to wait for an
/// interrupted computation.
constexpr milliseconds kTick{20}, kStopTimeout{50};

/// The state that the caller shares with the thread of the computation.
struct Shared {
  std::mutex lock;
  std::condition_variable ended;
  bool hasEnded = false;
  std::exception_ptr error;
  std::stop_source stop;
  std::atomic<double> part{0};

  bool waitFor(milliseconds time) {
    std::unique_lock guard(lock);
    return ended.wait_for(guard, time, [this] { return hasEnded; });
  }
};

struct DetachedThreads {
  std::mutex lock;
  std::vector<std::thread> threads;
};

DetachedThreads& detachedThreads() {
  static DetachedThreads all;
  return all;
}

/// Starts a thread that blocks all signals, as do threads that it starts: the interpreter handles
/// them.
template <class Function>
std::thread startWithoutSignals(Function function) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  try {
    std::thread thread(std::move(function));
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return thread;
  } catch (...) {
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    throw;
  }
}

}  // namespace

void runAndWait(std::function<void(const Call&)> work, const py::object& progress) {
  const auto shared = std::make_shared<Shared>();
  std::thread worker = startWithoutSignals([shared, work = std::move(work)]() mutable {
    std::exception_ptr error;
    try {
      work(Call(shared->stop.get_token(), shared->part));
    } catch (...) {
      error = std::current_exception();
    }
    work = nullptr;  // the caller finds all memory but the result's given back
    const std::scoped_lock guard(shared->lock);
    shared->error = error;
    shared->hasEnded = true;
    shared->ended.notify_all();
  });
  double reported = -1;
  const auto report = [&](double part) {
    if (progress.is_none() || !(part > reported)) return;  // it never goes back
    reported = part;
    progress(part);
  };
  const auto waitFor = [&](milliseconds time) {
    const py::gil_scoped_release others;
    return shared->waitFor(time);
  };
  try {
    while (!waitFor(kTick)) {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      report(shared->part.load(std::memory_order_relaxed));
    }
  } catch (...) {
    shared->stop.request_stop();
    if (waitFor(kStopTimeout)) {
      worker.join();
    } else {
      DetachedThreads& left = detachedThreads();
      const std::scoped_lock guard(left.lock);
      left.threads.push_back(std::move(worker));
    }
    throw;
  }
  worker.join();
  if (shared->error) std::rethrow_exception(shared->error);
  report(1);
}

void checkThreads(int threads) {
  constexpr int kMax = 1024;
  if (threads < 0 || threads > kMax)
    throw InputError("", "--threads", message("{} is outside 0 to {}", threads, kMax));
}

void joinDetachedThreads() {
  const py::gil_scoped_release others;
  DetachedThreads& left = detachedThreads();
  const std::scoped_lock guard(left.lock);
  for (std::thread& thread : left.threads) thread.join();
  left.threads.clear();
}

}  // namespace asperity
