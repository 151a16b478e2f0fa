#include "tests/bench/samples.h"

#include <algorithm>
#include <memory>

namespace asperity::bench {
namespace {

int defaultRepetitions = 5;
double defaultSeconds = 0.05;

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

double counterOf(const ::benchmark::BenchmarkReporter::Run& run, const char* name) {
  const auto found = run.counters.find(name);
  return found == run.counters.end() ? 0 : static_cast<double>(found->second);
}

}  // namespace

void setEffort(int repetitions, double seconds) {
  defaultRepetitions = repetitions;
  defaultSeconds = seconds;
}

void addCase(const std::string& name, const std::function<Body()>& prepare, Clock clock,
             int repetitions, double seconds, InstructionSet set) {
  const auto body = std::make_shared<Body>();
  auto* registered = ::benchmark::RegisterBenchmark(
      name.c_str(), [body, prepare, clock, set](::benchmark::State& state) {
        chooseInstructionSet(set);  // it asks the processor, which is slow: never in the loop
        if (!*body) *body = prepare();
        Tally tally;
        for (auto _ : state) tally = (*body)();
        chooseInstructionSet(InstructionSet::Best);
        state.counters["simulations"] = tally.simulations;
        state.counters["passes"] = tally.passes;
        state.counters["contact"] = tally.contactFraction;
        state.counters["scale"] = tally.scale;
        state.counters["wall"] = clock == Clock::Wall ? 1 : 0;
      });
  registered->Repetitions(repetitions > 0 ? repetitions : defaultRepetitions)
      ->MinTime(seconds > 0 ? seconds : defaultSeconds)
      ->Unit(::benchmark::kMicrosecond)
      ->ReportAggregatesOnly(false);
  if (clock == Clock::Wall) registered->UseRealTime();
}

void Samples::add(const std::string& name, double seconds, const Tally& tally) {
  Raw& raw = raw_[name];
  raw.seconds.push_back(seconds);
  raw.tally = tally;
}

std::optional<Sample> Samples::find(const std::string& name) const {
  const auto found = raw_.find(name);
  if (found == raw_.end()) return std::nullopt;
  const auto& [seconds, tally] = found->second;
  Sample sample;
  sample.seconds = medianOf(seconds) * tally.scale / tally.simulations;
  sample.passes = tally.passes / tally.simulations;
  sample.contactFraction = tally.contactFraction / tally.simulations;
  sample.isExtrapolated = tally.scale != 1;
  return sample;
}

void CollectingReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
    const double time =
        counterOf(run, "wall") > 0 ? run.real_accumulated_time : run.cpu_accumulated_time;
    samples_.add(run.run_name.function_name, time / static_cast<double>(run.iterations),
                 {counterOf(run, "simulations"), counterOf(run, "passes"),
                  counterOf(run, "contact"), counterOf(run, "scale")});
  }
  std::vector<Run> shown;
  for (const Run& run : runs)
    if (run.repetitions < 2 || run.aggregate_name == "median") shown.push_back(run);
  if (!shown.empty()) ConsoleReporter::ReportRuns(shown);
}

}  // namespace asperity::bench
