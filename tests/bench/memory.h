// Peak memory of an ensemble, measured in a process of its own. Threading: the main thread.
#pragma once

#include <optional>
#include <string>

namespace asperity::bench {

/// Runs the curve of Fig. 2 with 200 realizations on two threads and prints this process's largest
/// resident set (bytes). The body of the child.
int runMemoryChild(const std::string& resolution);

/// Starts this program again as that child and reads its answer (bytes); nothing where that fails.
std::optional<double> peakMemoryOf(const std::string& resolution);

}  // namespace asperity::bench
