// Progress on stderr: a bar on a terminal; into a pipe a line every ten seconds, so that the log of
// a long computation shows its progress; with the environment variable ASPERITY_PROGRESS, for a
// program that runs this one, lines of numbers: "progress DONE TOTAL WHAT", and "height GIVEN
// ENOUGH" of a picture that is too low. One thread at a time.
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
  bool isForProgram_;  // numbers are requested
  std::chrono::steady_clock::time_point drawn_{};
};

/// Tells a program that runs this one which height (pixels) a refused picture needs.
void tellNeededHeight(int given, int enough);

}  // namespace asperity
