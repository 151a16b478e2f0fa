// Instructions that this thread has retired, where the machine lets them be counted. Ownership: one
// owner; the counter ends with it. Threading: the thread that made it.
#pragma once

#include <cstdint>
#include <optional>

namespace asperity::bench {

class Instructions {
 public:
  Instructions();
  ~Instructions();
  Instructions(const Instructions&) = delete;
  Instructions& operator=(const Instructions&) = delete;

  /// In user mode, since it was made; nothing where they cannot be counted.
  std::optional<double> count() const;

 private:
  int file_;
};

}  // namespace asperity::bench
