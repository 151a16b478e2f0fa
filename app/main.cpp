// The process: its streams and signals, and its end. Every error is one line on stderr and an exit
// status. Ctrl+C or `kill` also end the program with one line, no unfinished file, and the exit
// status that shells use.
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <new>
#include <string_view>

#include "app/command_line.h"
#include "app/output.h"
#include "app/vector_target.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"

namespace asperity {
namespace {

struct Interruption {
  int signal, status;
  std::string_view line;
};

constexpr std::array<Interruption, 2> kInterruptions{
    {{SIGINT, kInterrupted, "asperity: interrupted; no unfinished file is left\n"},
     {SIGTERM, kTerminated, "asperity: terminated; no unfinished file is left\n"}}};

std::atomic<bool> isInterrupted{false};
constexpr const char* kNoOutput = "standard output cannot be written";
std::string_view eraseLine;  // escape sequence that erases the progress bar of a terminal

void writeError(std::string_view text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

/// Ends the program. It calls only functions that are safe in a signal handler.
void endProgram(int signal) {
  if (isInterrupted.exchange(true))
    while (true) ::pause();
  removeUnfinishedFiles();
  ::signal(SIGPIPE, SIG_IGN);  // the reader of stderr may have closed it
  for (const Interruption& interruption : kInterruptions) {
    if (interruption.signal != signal) continue;
    writeError(eraseLine);
    writeError(interruption.line);
    ::_exit(interruption.status);
  }
}

/// Installs the signal handlers, before other threads begin. A signal that was ignored before
/// (nohup) stays ignored.
void endCleanlyOnInterruption() {
  if (::isatty(STDERR_FILENO) == 1) eraseLine = "\r\033[K";
  for (const Interruption& interruption : kInterruptions) {
    struct sigaction before {};
    ::sigaction(interruption.signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = endProgram;
    sigemptyset(&action.sa_mask);
    for (const Interruption& other : kInterruptions) sigaddset(&action.sa_mask, other.signal);
    ::sigaction(interruption.signal, &action, nullptr);
  }
}

int reportError(const std::string& sentence, int status) {
  while (isInterrupted) ::pause();  // the interruption was the reason, and has been reported
  printError(sentence);
  return status;
}

/// Opens the closed standard streams, so that files opened later do not get their numbers.
void fillClosedStreams() {
  for (const int stream : {0, 1, 2})
    if (::fcntl(stream, F_GETFD) == -1) ::open("/dev/null", O_RDONLY);
}

int runProgram(int argc, char** argv) {
  fillClosedStreams();
  // A file that reaches its size limit gives an error, like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  endCleanlyOnInterruption();
  try {
    chooseVectorTarget();
    const int status = runCommandLine(argc, argv);
    // A full disk may appear only when the last bytes are written.
    if (std::fflush(stdout) != 0 || std::ferror(stdout)) return reportError(kNoOutput, kRunFailed);
    return status;
  } catch (const InputError& error) {
    return reportError(error.what(), kBadInput);
  } catch (const std::bad_alloc&) {
    return reportError("the scene needs more memory than there is", kRunFailed);
  } catch (const std::filesystem::filesystem_error& error) {
    return reportError(error.path1().string() + ": " + error.code().message(), kRunFailed);
  } catch (const std::exception& error) {
    // The library that prints throws where it cannot write.
    return reportError(std::ferror(stdout) != 0 ? kNoOutput : error.what(), kRunFailed);
  }
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  return asperity::runProgram(argc, argv);
}
