#include "app/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "ui/language/words.h"

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

void ProgressBar::show(std::int64_t done, std::int64_t total, const std::string& note) {
  const auto now = std::chrono::steady_clock::now();
  if (!visible_ || (done < total && now - drawn_ < kInterval)) return;
  drawn_ = now;
  const auto part = static_cast<std::size_t>(kWidth * done / total);
  const std::string line = fmt::format(
      "\r{} [{}{}] {}{}\033[K", what_, std::string(part, '='), std::string(kWidth - part, ' '),
      filled(Words::tr("%1 of %2"), {std::to_string(done), std::to_string(total)}),
      note.empty() ? "" : ", " + note);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace asperity
