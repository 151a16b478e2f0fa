#include "tests/bench/study_cost.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <vector>

#include "core/friction/ensemble.h"
#include "core/study/study_run.h"
#include "core/study/study_table.h"

namespace asperity::bench {
namespace {

/// Processor time of the program, which other programs disturb less than the time of a clock.
double processorSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The kernel alone: the balances of one chunk as slideStates cuts them into pieces.
double kernelSeconds(const ParameterStudy& study, std::int64_t number) {
  constexpr std::size_t kStates = 512;  // of a piece
  const std::int64_t count = study.sizeOfChunk(number);
  std::vector<double> point(2);
  std::vector<LoadCase> cases;
  for (std::int64_t i = 0; i < count; ++i) {
    study.space.pointInto(number * study.chunk + i, point);
    if (cases.empty() || cases.back().load.normalForce != point[0])
      cases.push_back({{LoadKind::Force, point[0], 0}, {}});
    cases.back().velocities.push_back(point[1]);
  }
  const double start = processorSeconds();
  const LineSource source(study.base, curvePointsPerElement(study.base));
  std::vector<RealizationPart> parts;
  const std::span<const LoadCase> all(cases);
  const bool isTable = std::ranges::all_of(
      cases, [&](const LoadCase& one) { return one.velocities == cases.front().velocities; });
  const std::size_t rows =
      isTable ? std::max<std::size_t>(1, kStates / cases.front().velocities.size()) : 1;
  for (std::size_t i = 0; i < cases.size(); i += rows)
    parts.push_back({study.base, all.subspan(i, std::min(rows, cases.size() - i)),
                     isTable && cases.size() > 1, true});
  double sum = 0;
  const RealizationWork work{source, parts};
  slideRealizations(work, 1, 1, {}, [&](std::span<const SteadyResult> results) {
    for (const SteadyResult& result : results) sum += result.mu;
  });
  return sum > 0 ? processorSeconds() - start : 0;
}

}  // namespace

StudyCost measureStudyCost(bool quick) {
  const int forces = quick ? 100 : 1000;
  const ParameterStudy study = readStudy(
      fmt::format(R"({{"schema":"asperity-study/1","set":{{"surface.elements":1000,)"
                  R"("ensemble.realizations":1,"accuracy.oversampling":2}},"space":)"
                  R"({{"load.normal_force":{{"from":1e-4,"to":1e-3,"points":{}}},)"
                  R"("sliding.velocity":{{"from":0.01,"to":1,"points":100}}}},"outputs":["mu"]}})",
                  forces),
      "bench", {});
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("asperity_study_{}", ::getpid());
  std::filesystem::create_directory(folder);
  StudyCost cost;
  cost.simulations = study.simulations();
  for (std::int64_t chunk = 0; chunk < study.chunks(); ++chunk)
    cost.kernelSeconds += kernelSeconds(study, chunk);
  {
    const double start = processorSeconds();
    StudyStore store(folder / "store", study, {});
    runStudy(store, {1, {}, {}});
    cost.runSeconds = processorSeconds() - start;
  }
  {
    const StudyStore store(folder / "store");
    const double start = processorSeconds();
    std::size_t bytes = 0;
    writeStudyTable(store, TableShape::Wide, TableFormat::Csv,
                    [&](std::string_view text) { bytes += text.size(); });
    cost.tableSeconds = processorSeconds() - start;
  }
  std::filesystem::remove_all(folder);
  return cost;
}

}  // namespace asperity::bench
