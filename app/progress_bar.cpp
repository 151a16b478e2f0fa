#include "app/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace asperity {
namespace {

constexpr int kWidth = 30;
constexpr std::chrono::milliseconds kInterval{50};

}  // namespace

ProgressBar::ProgressBar(std::string what, bool quiet)
    : what_(std::move(what)), visible_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (visible_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(std::int64_t done, std::int64_t total) {
  const auto now = std::chrono::steady_clock::now();
  if (!visible_ || (done < total && now - drawn_ < kInterval)) return;
  drawn_ = now;
  const auto filled = static_cast<std::size_t>(kWidth * done / total);
  const std::string line =
      fmt::format("\r{} [{}{}] {} of {}\033[K", what_, std::string(filled, '='),
                  std::string(kWidth - filled, ' '), done, total);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace asperity
