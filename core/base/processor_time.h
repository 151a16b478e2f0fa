// Processor time of the calling thread: the cost of work, whatever else the machine does.
#pragma once

#include <ctime>

namespace asperity {

inline double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace asperity
