// How the program ends after Ctrl+C or `kill`: one line on stderr, no unfinished file, and the exit
// status that shells use. isInterrupted() may be called on any thread.
#pragma once

namespace asperity {

/// Exit statuses after SIGINT and SIGTERM: 128 plus the number of the signal.
inline constexpr int kInterrupted = 130, kTerminated = 143;

/// Installs the signal handlers. A signal that was ignored before (nohup) stays ignored. Call it
/// once, on the main thread, before other threads begin.
void endCleanlyOnInterruption();

/// Returns whether the end has begun; later failures need no second message.
bool isInterrupted();

}  // namespace asperity
