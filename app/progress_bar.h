// A progress bar on stderr if it is a terminal; prints nothing into a pipe. One thread at a time.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace asperity {

class ProgressBar {
 public:
  /// Draws only where stderr is a terminal and quiet is false.
  ProgressBar(std::string what, bool quiet);
  ~ProgressBar();  // clears its line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// note: what stands behind the numbers, such as the time left.
  void show(std::int64_t done, std::int64_t total, const std::string& note = "");

 private:
  std::string what_;
  bool visible_;
  std::chrono::steady_clock::time_point drawn_{};
};

}  // namespace asperity
