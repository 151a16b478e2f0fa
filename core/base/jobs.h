// The number of threads to use, numbered jobs on oneTBB's threads and the caller's, and the
// processor time of a thread.
// Every job sees the caller's earlier writes, and the caller and later jobs see the writes of jobs:
// an atomic of this class ensures it, because race detectors cannot see the synchronization inside
// oneTBB's library.
// Ownership: one owner, from whose thread run() is called. Failure: run() throws what a job threw;
// jobs that have not begun are then left out.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <ctime>
#include <memory>
#include <thread>

namespace asperity {

/// Returns the number of threads to use: `wanted`, or as many as the machine has for 0.
inline int threadCount(int wanted) {
  return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Returns the processor time of the calling thread, s: the cost of work, whatever else the machine
/// does.
inline double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Jobs {
 public:
  /// threads: 0 means as many as the machine has.
  explicit Jobs(int threads);
  ~Jobs();

  /// Calls job(0) to job(count - 1), each once, in any order and on any thread.
  template <class Job>
  void run(std::int64_t count, const Job& job) {
    const HandOver caller;
    runEach(count, &call<Job>, &job);
  }

 private:
  /// Publishes this thread's writes for the next thread that takes them, also in the destructor.
  /// There is one for the process, because a job must take before it follows the first pointer.
  struct HandOver {
    HandOver() { count.fetch_add(1, std::memory_order_acq_rel); }
    ~HandOver() { count.fetch_add(1, std::memory_order_acq_rel); }
    HandOver(const HandOver&) = delete;
    HandOver& operator=(const HandOver&) = delete;
    static inline std::atomic<std::uint64_t> count{0};
  };

  using Call = void (*)(const void* job, std::int64_t number);

  template <class Job>
  static void call(const void* job, std::int64_t number) {
    const HandOver worker;
    (*static_cast<const Job*>(job))(number);
  }

  void runEach(std::int64_t count, Call one, const void* job);

  struct Arena;
  std::unique_ptr<Arena> arena_;
};

}  // namespace asperity
