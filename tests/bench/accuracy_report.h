// What the accuracy of curves costs and promises, as a page of Markdown: predictions against runs,
// multilevel against plain averaging, how often the stated intervals hold, and what mirrored lines
// would do. Threading: the main thread.
#pragma once

#include <string>

namespace asperity::bench {

std::string accuracyReport(bool isQuick);

}  // namespace asperity::bench
