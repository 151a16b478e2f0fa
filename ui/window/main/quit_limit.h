// The longest that the end of the program may take. Work in the background is asked to stop and
// mostly does within milliseconds; a transform of millions of points, or a disk that does not
// answer, cannot be asked. Files are safe from a sudden end: each is whole or not there.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace asperity {

/// From its making on the process has this long to end or to destroy the limit; otherwise it ends
/// with this status, whatever runs. Threading: made and destroyed on one thread.
class QuitLimit {
 public:
  QuitLimit(std::chrono::milliseconds limit, int status);
  ~QuitLimit();
  QuitLimit(const QuitLimit&) = delete;
  QuitLimit& operator=(const QuitLimit&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool isOver_ = false;
  std::thread thread_;  // last: uses the above
};

}  // namespace asperity
