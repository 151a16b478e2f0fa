// asperity_bench [--quick] [--accuracy] [--effects] [--arms] [--maps] [--output FOLDER]
//                [Google Benchmark's options]
// Measures, prints the tables, and writes them to FOLDER/<CPU name>.md. With a filter only what ran
// is printed and nothing is written. --accuracy, --effects: only the page on accuracy, on effects.
// --arms, --maps: only the section on elements with arms, on maps, printed and not written.
// Exit: 0 done, 1 failed, 2 bad usage.
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

#include "core/contact/kernels/kernels.h"
#include "tests/bench/accuracy_report.h"
#include "tests/bench/arms_report.h"
#include "tests/bench/cancel.h"
#include "tests/bench/effects_report.h"
#include "tests/bench/fields.h"
#include "tests/bench/line_store.h"
#include "tests/bench/machine.h"
#include "tests/bench/maps_report.h"
#include "tests/bench/memory.h"
#include "tests/bench/report.h"
#include "tests/bench/samples.h"
#include "tests/bench/study_cost.h"

namespace asperity::bench {
namespace {

struct Options {
  bool isQuick = false, isFiltered = false, isAccuracy = false, isEffects = false, isArms = false,
       isMaps = false;
  std::string output, memoryChild;
  std::vector<char*> rest;  // for Google Benchmark
};

Options readOptions(int count, char** arguments) {
  Options options;
  for (int i = 0; i < count; ++i) {
    const std::string argument = arguments[i];
    const bool hasValue = i + 1 < count;
    if (argument == "--quick")
      options.isQuick = true;
    else if (argument == "--accuracy")
      options.isAccuracy = true;
    else if (argument == "--effects")
      options.isEffects = true;
    else if (argument == "--arms")
      options.isArms = true;
    else if (argument == "--maps")
      options.isMaps = true;
    else if (argument == "--output" && hasValue)
      options.output = arguments[++i];
    else if (argument == "--memory-child" && hasValue)
      options.memoryChild = arguments[++i];
    else
      options.rest.push_back(arguments[i]);
    options.isFiltered |= argument.starts_with("--benchmark_filter") ||
                          argument.starts_with("--benchmark_list_tests");
  }
  return options;
}

void addCases(bool quick) {
  setEffort(quick ? 3 : 7, quick ? 0.01 : 0.05);
  addSweepCases(quick);
  addCurveCases(quick);
  addGrowthCases(quick);
  addLiteralCases(quick);
}

/// What is not a case of Google Benchmark: memory, cancelling, and the sample of the paper's study.
void measureRest(const Options& options, Measured& measured) {
  measured.clock = measuredClock();
  if (options.isFiltered) return;
  clearLines();
  measured.peakMemory = peakMemoryOf("cubic_x2");
  measured.peakMemoryNodal = peakMemoryOf("nodal");
  const int tries = options.isQuick ? 3 : 20;
  measured.cancel = slowestCancel(5000, tries);
  measured.cancelLong = slowestCancel(200000, tries);
  measured.studyCost = measureStudyCost(options.isQuick);
  measured.studyLinear = estimateStudy(Scheme::Linear, 1, options.isQuick);
  measured.studyCubic = estimateStudy(Scheme::Cubic, 2, options.isQuick);
  if (instructionSet() == InstructionSet::Avx2 || !chooseInstructionSet(InstructionSet::Avx2))
    return;
  measured.studyLinearAvx2 = estimateStudy(Scheme::Linear, 1, options.isQuick);
  measured.studyCubicAvx2 = estimateStudy(Scheme::Cubic, 2, options.isQuick);
  chooseInstructionSet(InstructionSet::Best);
}

bool write(const std::string& folder, const char* what, const std::string& page) {
  const std::string file = folder + "/" + cpuFileName() + what + ".md";
  std::ofstream out(file);
  out << page;
  out.close();
  if (!out) std::fprintf(stderr, "asperity_bench: cannot write %s\n", file.c_str());
  return static_cast<bool>(out);
}

/// A page beside the main one; false where it cannot be written.
bool addPage(const Options& options, const char* what, const std::string& page) {
  std::printf("\n%s", page.c_str());
  return options.output.empty() || write(options.output, what, page);
}

int run(int count, char** arguments) {
  Options options = readOptions(count, arguments);
  if (!options.memoryChild.empty()) return runMemoryChild(options.memoryChild);
  int left = static_cast<int>(options.rest.size());
  ::benchmark::Initialize(&left, options.rest.data());
  if (::benchmark::ReportUnrecognizedArguments(left, options.rest.data())) return 2;
  if (options.isArms) {
    std::printf("%s", armsSection(options.isQuick).c_str());
    return 0;
  }
  if (options.isMaps) {
    std::printf("%s", mapsSection(options.isQuick).c_str());
    return 0;
  }
  const bool isOnePage = options.isAccuracy || options.isEffects;
  if (!options.isFiltered || isOnePage) {
    if ((options.isEffects || !isOnePage) &&
        !addPage(options, "_effects",
                 effectsReport(options.isQuick) + "\n" + armsSection(options.isQuick) + "\n" +
                     mapsSection(options.isQuick)))
      return 1;
    if ((options.isAccuracy || !isOnePage) &&
        !addPage(options, "_accuracy", accuracyReport(options.isQuick)))
      return 1;
    if (isOnePage) return 0;
  }
  Measured measured;
  measured.instructionSets = instructionSets();
  measured.isQuick = options.isQuick;
  measured.loadBefore = loadAverage();
  addCases(options.isQuick);
  CollectingReporter reporter(measured.samples);
  ::benchmark::RunSpecifiedBenchmarks(&reporter);
  measureRest(options, measured);
  const std::string page = report(measured);
  std::printf("\n%s", page.c_str());
  if (options.output.empty() || options.isFiltered) return 0;
  return write(options.output, "", page) ? 0 : 1;
}

}  // namespace
}  // namespace asperity::bench

int main(int count, char** arguments) {
  try {
    return asperity::bench::run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "asperity_bench: %s\n", error.what());
    return 1;
  }
}
