// Progress on stderr: a bar on a terminal; into a pipe a line every ten seconds, so that the log of
// a long computation shows its progress; with the environment variable ASPERITY_PROGRESS, for a
// program that shows its own bar, lines "progress DONE TOTAL WHAT". One thread at a time.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace asperity {

class ProgressBar {
 public:
  /// Shows nothing where quiet is true.
  ProgressBar(std::string what, bool quiet);
  ~ProgressBar();  // clears its line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Shows the progress. note: the text after the numbers, such as the time left.
  void show(std::int64_t done, std::int64_t total, const std::string& note = "");
  /// Shows the finished part, 0 to 1.
  void showPart(double part) { show(static_cast<std::int64_t>(1000 * part), 1000); }

 private:
  std::string what_;
  bool isQuiet_, isTerminal_;
  bool isForProgram_;  // the environment variable ASPERITY_PROGRESS requests numbers
  std::chrono::steady_clock::time_point drawn_{};
};

}  // namespace asperity
