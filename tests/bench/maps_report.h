// What maps of friction over two parameters cost: the first picture, the whole, cancelling, and a
// map whose states share one scaling against one curve a row. Threading: the main thread; the maps
// use two threads.
#pragma once

#include <string>

namespace asperity::bench {

/// A section in Markdown. Throws std::runtime_error where a balance is not met.
std::string mapsSection(bool isQuick);

}  // namespace asperity::bench
