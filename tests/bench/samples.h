// What the benchmarks measured: one sample a case, the median of its repetitions.
// Threading: filled by the reporter on the main thread, then read.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/contact/kernels/kernels.h"

namespace asperity::bench {

/// Per iteration of a case.
struct Tally {
  double simulations = 1;      // one line, one velocity, one force, its balance solved
  double passes = 0;           // over the line, all simulations together
  double contactFraction = 0;  // sum over the simulations
  double scale = 1;            // time is multiplied by this: more than 1 where extrapolated
};

struct Sample {
  double seconds = 0;  // per simulation, median of the repetitions
  double passes = 0;   // per simulation
  double contactFraction = 0;
  bool isExtrapolated = false;
};

enum class Clock { Cpu, Wall };

/// Registers a case. `prepare` runs once, before the first repetition and outside the timing, and
/// returns what is timed, on this instruction set.
using Body = std::function<Tally()>;
void addCase(const std::string& name, const std::function<Body()>& prepare,
             Clock clock = Clock::Cpu, int repetitions = 0, double seconds = 0,
             InstructionSet set = InstructionSet::Best);

/// Repetitions and the least time of each, for cases that do not say.
void setEffort(int repetitions, double seconds);

class Samples {
 public:
  void add(const std::string& name, double seconds, const Tally& tally);
  /// Nothing where the case did not run (a filter).
  std::optional<Sample> find(const std::string& name) const;

 private:
  struct Raw {
    std::vector<double> seconds;
    Tally tally;
  };
  std::map<std::string, Raw> raw_;
};

/// Prints Google Benchmark's lines as they come and keeps the samples.
class CollectingReporter : public ::benchmark::ConsoleReporter {
 public:
  explicit CollectingReporter(Samples& samples) : ConsoleReporter(OO_Tabular), samples_(samples) {}
  void ReportRuns(const std::vector<Run>& runs) override;

 private:
  Samples& samples_;
};

}  // namespace asperity::bench
