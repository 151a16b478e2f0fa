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

/// How often Ctrl+C is looked for and progress is told, and how long an interrupted computation is
/// waited for.
constexpr milliseconds kTick{20}, kPatience{50};

/// What the caller and the thread of the computation share.
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

struct LeftBehind {
  std::mutex lock;
  std::vector<std::thread> threads;
};

LeftBehind& leftBehind() {
  static LeftBehind all;
  return all;
}

/// Starts a thread that takes no signals, nor do those that it starts: they are the interpreter's.
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
  double told = -1;
  const auto tell = [&](double part) {
    if (progress.is_none() || !(part > told)) return;  // it never goes back
    told = part;
    progress(part);
  };
  const auto waitFor = [&](milliseconds time) {
    const py::gil_scoped_release others;
    return shared->waitFor(time);
  };
  try {
    while (!waitFor(kTick)) {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      tell(shared->part.load(std::memory_order_relaxed));
    }
  } catch (...) {
    shared->stop.request_stop();
    if (waitFor(kPatience)) {
      worker.join();
    } else {
      LeftBehind& left = leftBehind();
      const std::scoped_lock guard(left.lock);
      left.threads.push_back(std::move(worker));
    }
    throw;
  }
  worker.join();
  if (shared->error) std::rethrow_exception(shared->error);
  tell(1);
}

void checkThreads(int threads) {
  constexpr int kMost = 1024;
  if (threads < 0 || threads > kMost)
    throw InputError("", "--threads", message("{} is outside 0 to {}", threads, kMost));
}

void joinLeftBehind() {
  const py::gil_scoped_release others;
  LeftBehind& left = leftBehind();
  const std::scoped_lock guard(left.lock);
  for (std::thread& thread : left.threads) thread.join();
  left.threads.clear();
}

}  // namespace asperity
