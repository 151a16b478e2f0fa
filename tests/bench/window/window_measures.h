// What a person waits for at the window, measured. GUI thread, with an application.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace asperity::bench {

struct WindowMeasure {
  std::string what, unit;
  bool isAtMost = true;  // of its limit; else at least
  std::optional<double> limit;
  double value = 0;
};

/// Throws std::runtime_error where the window does not do what is measured.
std::vector<WindowMeasure> measureWindow(bool isQuick);

}  // namespace asperity::bench
