// Parts of the report: how cost grows, how near the machine's peak it is, whole curves and memory.
// Each is empty where nothing of it was measured. Threading: the main thread.
#pragma once

#include <string>

#include "tests/bench/targets.h"

namespace asperity::bench {

std::string growthSection(const Measured& measured);
std::string peakSection(const Measured& measured);
std::string curveSection(const Measured& measured);

}  // namespace asperity::bench
