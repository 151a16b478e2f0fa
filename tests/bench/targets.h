// The targets, each a row: what was wanted and what was measured. Threading: the main thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/paper_study.h"
#include "tests/bench/samples.h"
#include "tests/bench/study_cost.h"

namespace asperity::bench {

/// Everything measured in one run; what a filter left out is absent.
struct Measured {
  Samples samples;
  std::vector<std::string> instructionSets;  // narrowest first
  double clock = 0;                          // Hz
  double loadBefore = 0;                     // of the machine by others, before the run
  bool isQuick = false;
  std::optional<double> peakMemory;       // bytes, cubic x2
  std::optional<double> peakMemoryNodal;  // bytes
  std::optional<StudyEstimate> studyLinear, studyCubic;
  std::optional<StudyEstimate> studyLinearAvx2, studyCubicAvx2;  // where it is not the best one
  std::optional<StudyCost> studyCost;
  std::optional<double> cancel, cancelLong;  // s, slowest: N = 5000 and 200,000

  /// The literal algorithm at Fig. 2 over the shipped path: seconds over seconds.
  std::optional<double> ratio(const std::string& slow, const std::string& fast) const;
};

/// Target, measured, and met or missed, as a Markdown table.
std::string targetTable(const Measured& measured);

}  // namespace asperity::bench
