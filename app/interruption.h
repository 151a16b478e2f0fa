// How the program ends when it is told to by Ctrl+C or by `kill`: one line on stderr, no unfinished
// file left, and the exit status that shells use for it.
#pragma once

namespace asperity {

/// SIGINT and SIGTERM: 128 and the number of the signal.
inline constexpr int kInterrupted = 130, kTerminated = 143;

/// From now on the process ends so. A signal that was ignored before (nohup) stays ignored. Once,
/// on the main thread, before any other begins.
void endCleanlyOnInterruption();

/// Whether the end has begun: what fails from then on is not worth a second line.
bool isInterrupted();

}  // namespace asperity
