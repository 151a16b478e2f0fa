// asperity sensitivity: how much friction changes with each parameter at the scene's own state; and
// asperity cutoff: friction against the short-wave cut-off of the line.
#include "app/command_line.h"
#include "app/progress_bar.h"
#include "app/result_files.h"
#include "core/chart/influence_sheets.h"
#include "core/friction/curve_point.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "core/surface/measured_summary.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

/// Runs the computation of states of one scene, with a progress bar.
template <class Work>
auto computeStates(const TableCommand& command, const Work& work) {
  return withSceneContext(command.common, [&] {
    ProgressBar bar(Words::tr("states"), command.common.quiet);
    return work(StateOptions{.threads = command.common.threads,
                             .progress = [&bar](double part) { bar.showPart(part); }});
  });
}

}  // namespace

int runSensitivity(const TableCommand& command) {
  const Scene scene = loadScene(command.common);
  withSceneContext(command.common, [&] { requireSteadySliding(scene, "asperity sensitivity"); });
  const PictureSettings settings = checkTableOutputs(command, scene);
  const std::vector<Exponent> exponents = computeStates(command, [&](const StateOptions& options) {
    return sensitivityExponents(scene, sensitivities(scene, options));
  });
  const auto origin = [&] { return provenance("sensitivity", scene); };
  writeResult(command, settings,
              {.csv = [&] { return provenanceComment(origin()) + sensitivityCsv(exponents); },
               .json = [&] { return sensitivityJson(scene, exponents); },
               .sheet = [&] { return sensitivitySheet(scene, exponents); },
               .origin = origin,
               .summary = translatedLine(pressureNote(scene)),
               .reading = readingFacts(scene),
               .printed = sensitivityText(exponents, {Words::tr("parameter"), Words::tr("value"),
                                                      Words::tr("exponent"), Words::tr("error")})});
  return kDone;
}

int runCutoff(const TableCommand& command) {
  const Scene scene = loadScene(command.common);
  withSceneContext(command.common, [&] { requireSteadySliding(scene, "asperity cutoff"); });
  const PictureSettings settings = checkTableOutputs(command, scene);
  const std::vector<CutoffPoint> points = computeStates(
      command, [&](const StateOptions& options) { return frictionOverCutoff(scene, options); });
  NoteSet notes;
  if (!points.empty()) notes.add(points.back().state.notes);  // of the whole line
  const auto origin = [&] { return provenance("cutoff", scene); };
  writeResult(command, settings,
              {.csv = [&] { return provenanceComment(origin()) + cutoffCsv(points); },
               .json = [&] { return cutoffJson(scene, points); },
               .sheet = [&] { return cutoffSheet(scene, points); },
               .origin = origin,
               .summary = translatedLines(describeCutoff(points)) +
                          translatedLine(pressureNote(scene)) + noteLines(notes),
               .reading = readingFacts(scene)});
  return kDone;
}

}  // namespace asperity
