// What elements with arms (a Prony series) cost beside Kelvin's on the curve of Fig. 2, on every
// instruction set; whole curves as a slider asks for them; and the growth from 1 to 64 arms.
// Threading: the main thread.
#pragma once

#include <string>

namespace asperity::bench {

/// A section in Markdown. Throws std::runtime_error where a balance is not met.
std::string armsSection(bool isQuick);

}  // namespace asperity::bench
