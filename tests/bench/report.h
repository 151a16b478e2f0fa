// Everything measured, as one page of Markdown: ratios first. Threading: the main thread.
#pragma once

#include <string>

#include "tests/bench/targets.h"

namespace asperity::bench {

std::string report(const Measured& measured);

}  // namespace asperity::bench
