#include "app/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "core/base/message.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

constexpr const char* kForProgram = "ASPERITY_PROGRESS";  // requests numbers
constexpr int kWidth = 30;
constexpr std::chrono::milliseconds kInterval{50}, kLineInterval{10000};

}  // namespace

ProgressBar::ProgressBar(std::string what, bool quiet)
    : what_(std::move(what)),
      isQuiet_(quiet),
      isTerminal_(::isatty(STDERR_FILENO) == 1),
      isForProgram_(std::getenv(kForProgram) != nullptr) {
  if (!isTerminal_) drawn_ = std::chrono::steady_clock::now();  // short work has no line
}

ProgressBar::~ProgressBar() {
  if (!isQuiet_ && isTerminal_ && !isForProgram_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(std::int64_t done, std::int64_t total, const std::string& note) {
  const auto now = std::chrono::steady_clock::now();
  if (isQuiet_) return;
  if (isForProgram_) {
    if (done < total && now - drawn_ < kInterval) return;
    drawn_ = now;
    std::fputs(fmt::format("progress {} {} {}\n", done, total, what_).c_str(), stderr);
    return;
  }
  std::string count = filled(Words::tr("%1 of %2"), {std::to_string(done), std::to_string(total)});
  if (!note.empty()) count += ", " + note;
  if (!isTerminal_) {
    if (now - drawn_ < kLineInterval) return;
    drawn_ = now;
    std::fputs(fmt::format("{}: {}\n", what_, count).c_str(), stderr);
    return;
  }
  if (done < total && now - drawn_ < kInterval) return;
  drawn_ = now;
  const auto part = static_cast<std::size_t>(kWidth * done / total);
  const std::string line = fmt::format("\r{} [{}{}] {}\033[K", what_, std::string(part, '='),
                                       std::string(kWidth - part, ' '), count);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

void tellNeededHeight(int given, int enough) {
  if (std::getenv(kForProgram) != nullptr)
    std::fputs(fmt::format("height {} {}\n", given, enough).c_str(), stderr);
}

}  // namespace asperity
