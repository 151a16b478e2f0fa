// asperity curve: friction over velocity, averaged over the scene's realizations.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "app/command_line.h"
#include "app/output.h"
#include "app/progress_bar.h"
#include "core/accuracy/target_curve.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/scene/atomic_file.h"
#include "core/scene/effects.h"
#include "core/scene/input_error.h"

namespace asperity {
namespace {

Curve compute(const Scene& scene, const CommonOptions& common) {
  ProgressBar bar("realizations", common.quiet);
  CurveOptions options;
  options.threads = common.threads;
  options.progress = [&bar](const CurveProgress& progress) {
    bar.show(progress.realizationsDone, progress.realizationsTotal);
  };
  return saidOfScene(common, [&] { return curveOf(scene, options); });
}

std::string summaryOf(const Curve& curve, const std::vector<std::string>& outputs) {
  std::string text = fmt::format("{} velocities, {} realizations", curve.points.size(),
                                 curve.points.front().realizations);
  if (curve.marginalFraction > 0)
    text += fmt::format(", {:.1f} % of the balances with a partly loaded element",
                        100 * curve.marginalFraction);
  if (std::isfinite(curve.achievedError))
    text += fmt::format("\nrelative error at most {:.2g} at every velocity, target {}",
                        curve.achievedError, curve.isTargetMet ? "met" : "not met");
  for (const std::string& output : outputs) text += fmt::format("\nwrote {}", output);
  return text + "\n";
}

}  // namespace

int runCurve(const CurveCommand& command) {
  const Scene scene = sceneOf(command.common);
  saidOfScene(command.common, [&] { needSteadySliding(scene, "asperity curve"); });
  checkOutputs(command.outputs, {".csv", ".json"});
  const Curve curve = compute(scene, command.common);
  for (const std::string& output : command.outputs)
    writeFileAtomically(output, extensionOf(output) == ".csv" ? curveCsv(curve.points)
                                                              : curveJson(curve.points, scene));
  const bool tableOnStdout = command.outputs.empty();
  if (command.common.json)
    fmt::print("{}", curveJson(curve.points, scene));
  else if (tableOnStdout)
    fmt::print("{}", curveCsv(curve.points));
  if (!tableOnStdout)
    printSummary(command.common.json, command.common.quiet, summaryOf(curve, command.outputs));
  if (!curve.isTargetMet)
    throw std::runtime_error(
        fmt::format("accuracy.target_relative_error is not reached within the lines and memory "
                    "allowed: {:.2g}",
                    curve.achievedError));
  return kDone;
}

}  // namespace asperity
