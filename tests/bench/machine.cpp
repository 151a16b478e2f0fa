#include "tests/bench/machine.h"

#include <cstdlib>
#include <ctime>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>

namespace asperity::bench {

std::string cpuName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown CPU";
}

std::string cpuFileName() {
  std::string name;
  for (const char c : cpuName()) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain) name += c;
    if (!plain && !name.empty() && name.back() != '_') name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

double loadAverage() {
  double averages[2];
  return getloadavg(averages, 2) == 2 ? averages[1] : -1;
}

double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double measuredClock() {
  constexpr std::int64_t kRounds = 1000000, kChain = 16;
  double best = 0;
  for (int run = 0; run < 20; ++run) {
    std::uint64_t sum = 0, step = 1;
    asm volatile("" : "+r"(step));  // unknown to the compiler and to the processor's front end
    const double start = threadSeconds();
    for (std::int64_t i = 0; i < kRounds; ++i)
      for (std::int64_t k = 0; k < kChain; ++k) {
        sum += step;
        asm volatile("" : "+r"(sum));
      }
    const double seconds = threadSeconds() - start;
    best = std::max(best, static_cast<double>(kRounds * kChain) / seconds);
  }
  return best;
}

}  // namespace asperity::bench
