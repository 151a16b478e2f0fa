#include "tests/bench/instructions.h"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace asperity::bench {

Instructions::Instructions() {
  perf_event_attr wanted{};
  wanted.size = sizeof wanted;
  wanted.type = PERF_TYPE_HARDWARE;
  wanted.config = PERF_COUNT_HW_INSTRUCTIONS;
  wanted.exclude_kernel = wanted.exclude_hv = 1;
  file_ = static_cast<int>(syscall(SYS_perf_event_open, &wanted, 0, -1, -1, 0));
}

Instructions::~Instructions() {
  if (file_ >= 0) close(file_);
}

std::optional<double> Instructions::count() const {
  std::uint64_t value = 0;
  if (file_ < 0 || read(file_, &value, sizeof value) != sizeof value || value == 0)
    return std::nullopt;
  return static_cast<double>(value);
}

}  // namespace asperity::bench
