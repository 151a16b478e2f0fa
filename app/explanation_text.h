// The plan of a scene and what it will cost, as a person reads them, in the language in use. Pure
// once the language is chosen; any thread.
#pragma once

#include <string>

#include "core/accuracy/explanation.h"

namespace asperity {

std::string explanationText(const Explanation& explanation);

}  // namespace asperity
