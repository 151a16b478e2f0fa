#include "core/accuracy/map_cost.h"

#include <algorithm>

#include "core/accuracy/pilot.h"
#include "core/base/jobs.h"
#include "core/base/processor_time.h"
#include "core/base/stop.h"

namespace asperity {
namespace {

constexpr double kMaxTrial = 0.5;        // s, of one line in all cells
constexpr double kMaxSecondTrial = 0.1;  // s, of one line, where more lines are tried, too

struct Trial {
  ParameterMap map;
  double seconds = 0;  // of the processor

  double cells() const { return static_cast<double>(map.points.size()); }
};

Trial runTrial(MapStage stage, const Scene& scene, const MapAxis& x, const MapAxis& y,
               const std::stop_token& stop) {
  MapOptions options{.threads = 1, .stop = stop};
  const double begin = threadSeconds();
  Trial trial{mapStage(stage, scene, x, y, options)};
  if (!trial.map.isComplete) throw StopRequested{};
  trial.seconds = threadSeconds() - begin;
  return trial;
}

}  // namespace

MapCost predictMap(const Scene& scene, const MapAxis& x, const MapAxis& y, int threads,
                   const std::stop_token& stop) {
  MapCost cost{x.values.size(), y.values.size()};
  cost.threads = threadCount(threads);
  const auto cells = static_cast<double>(cost.columns * cost.rows);
  Trial trial = runTrial(MapStage::Coarse, scene, x, y, stop);
  // Which cells are equal is known only where all are tried.
  if (trial.cells() < cells && trial.seconds * cells / trial.cells() < kMaxTrial)
    trial = runTrial(MapStage::OneLine, scene, x, y, stop);
  if (trial.cells() == cells) cost.different = trial.map.computed;
  cost.lines = static_cast<double>(planPilot(scene, cost.threads).run.lines);
  double perLine = trial.seconds * cells / trial.cells();
  double once = 0;  // to find equal states and to gather them, whatever the number of lines is
  if (cost.lines > 1 && trial.cells() == cells && trial.seconds < kMaxSecondTrial) {
    const Trial few = runTrial(MapStage::FewLines, scene, x, y, stop);
    const auto more = static_cast<double>(few.map.lines - trial.map.lines);
    perLine = std::clamp((few.seconds - trial.seconds) / more, 0.0, trial.seconds);
    once = trial.seconds - perLine;
  }
  cost.seconds = once + perLine * cost.lines / cost.threads;
  return cost;
}

}  // namespace asperity
