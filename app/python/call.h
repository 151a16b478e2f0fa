// A computation that Python waits for: it runs on a thread of its own while the interpreter is free
// for other Python threads, Ctrl+C ends it, and a Python function receives its progress. Threading:
// the Python function and the check for Ctrl+C run on the calling thread; the computation touches
// no Python object. Failure: exceptions of the computation and of the Python function are passed
// on, and KeyboardInterrupt.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <type_traits>
#include <utility>

namespace asperity {

/// The interface of the waiting call for the computation.
class Call {
 public:
  Call(std::stop_token stop, std::atomic<double>& part) : stop_(std::move(stop)), part_(part) {}

  const std::stop_token& stop() const { return stop_; }
  /// Reports the finished part of the work, 0 to 1; from any thread.
  void report(double part) const { part_.store(part, std::memory_order_relaxed); }
  void report(std::int64_t done, std::int64_t total) const {
    if (total > 0) report(static_cast<double>(done) / static_cast<double>(total));
  }

 private:
  std::stop_token stop_;
  std::atomic<double>& part_;
};

/// Runs the work and returns when it has ended. progress: a Python function of the part that is
/// done, or None. The work must own all that it uses: where it does not end soon after Ctrl+C, it
/// is left behind and its result is dropped.
void runAndWait(std::function<void(const Call&)> work, const pybind11::object& progress);

/// Throws InputError for a number of threads that the program does not take either.
void checkThreads(int threads);

/// Joins what was left behind. Called once, when the interpreter ends.
void joinDetachedThreads();

/// Does the same and returns the result of the work.
template <class Work>
auto compute(const pybind11::object& progress, Work work) {
  using Result = std::invoke_result_t<Work&, const Call&>;
  const auto result = std::make_shared<std::optional<Result>>();
  runAndWait([result, work = std::move(work)](const Call& call) { result->emplace(work(call)); },
             progress);
  return std::move(**result);
}

}  // namespace asperity
