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

int runCutoff(const TableCommand& command) {
  const Scene scene = loadScene(command.common);
  withSceneContext(command.common, [&] { requireSteadySliding(scene, "asperity cutoff"); });
  const PictureSettings settings = checkTableOutputs(command, scene);
  const std::vector<CutoffPoint> points = withSceneContext(command.common, [&] {
    ProgressBar bar(Words::tr("states"), command.common.quiet);
    StateOptions options{.threads = command.common.threads,
                         .progress = [&bar](double part) { bar.showPart(part); }};
    return frictionOverCutoff(scene, options);
  });
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
