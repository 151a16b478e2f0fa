// The machine a benchmark ran on. Threading: the main thread.
#pragma once

#include <string>

namespace asperity::bench {

/// As the kernel names it; "unknown CPU" where it does not.
std::string cpuName();

/// The same with letters, digits and underscores only, for a file's name.
std::string cpuFileName();

/// Clock (Hz) under load, from a chain of additions of one cycle each; the fastest of several runs.
double measuredClock();

/// Programs that wanted to run in the last five minutes, on average; negative where not known.
double loadAverage();

/// CPU time of this thread (s).
double threadSeconds();

}  // namespace asperity::bench
