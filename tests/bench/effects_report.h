// What each effect costs, as a page of Markdown: time per element for every combination of element,
// scheme, load, motion and interface; growth with the number of arms; and that an effect of no
// strength costs nothing. Combinations take turns and the fastest turn of each counts.
// Threading: the main thread.
#pragma once

#include <string>

namespace asperity::bench {

std::string effectsReport(bool isQuick);

}  // namespace asperity::bench
