#include "app/interruption.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <string_view>

#include "core/base/atomic_file.h"

namespace asperity {
namespace {

struct Ending {
  int signal, status;
  std::string_view line;
};

constexpr std::array<Ending, 2> kEndings{
    {{SIGINT, kInterrupted, "asperity: interrupted; no unfinished file is left\n"},
     {SIGTERM, kTerminated, "asperity: terminated; no unfinished file is left\n"}}};

std::atomic<bool> hasBegun{false};
std::string_view clearsLine;  // characters that clear a progress bar on a terminal

void writeError(std::string_view text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

/// Ends the program. It calls only functions that are safe in a signal handler.
void end(int signal) {
  if (hasBegun.exchange(true))
    while (true) ::pause();
  removeUnfinishedFiles();
  ::signal(SIGPIPE, SIG_IGN);  // the reader of stderr may have closed it
  for (const Ending& ending : kEndings) {
    if (ending.signal != signal) continue;
    writeError(clearsLine);
    writeError(ending.line);
    ::_exit(ending.status);
  }
}

}  // namespace

void endCleanlyOnInterruption() {
  if (::isatty(STDERR_FILENO) == 1) clearsLine = "\r\033[K";
  for (const Ending& ending : kEndings) {
    struct sigaction before {};
    ::sigaction(ending.signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = end;
    sigemptyset(&action.sa_mask);
    for (const Ending& other : kEndings) sigaddset(&action.sa_mask, other.signal);
    ::sigaction(ending.signal, &action, nullptr);
  }
}

bool isInterrupted() {
  return hasBegun;
}

}  // namespace asperity
