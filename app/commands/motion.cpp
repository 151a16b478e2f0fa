// asperity motion: friction, indentation, contact and power over time while the velocity changes,
// as a table and as a picture.
#include "core/run/motion_table.h"

#include <cmath>

#include "app/command_line.h"
#include "app/output.h"
#include "app/progress_bar.h"
#include "app/result_files.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "core/surface/measured_summary.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

/// The size of texts relative to the usual one, times the scale. Four strips make texts this small
/// in the usual picture; a picture of few pixels for print then has relatively larger texts.
constexpr float kMotionText = 0.6F;

MotionTable compute(const Scene& scene, const MotionCommand& command) {
  ProgressBar bar(Words::tr("time steps"), command.common.quiet);
  MotionOptions options{
      .every = command.every,
      .lines = command.lines,
      .threads = command.common.threads,
      .progress = [&bar](std::int64_t done, std::int64_t total) { bar.show(done, total); }};
  return withSceneContext(command.common, [&] { return marchMotion(scene, options); });
}

std::string summaryText(const MotionTable& table) {
  std::string text =
      filled(Words::tr("%1 rows of each of %2 lines"),
             {std::to_string(table.lines.front().size()), std::to_string(table.lines.size())});
  if (table.lines.size() == 1)
    text = filled(Words::tr("%1 rows"), {std::to_string(table.lines.front().size())});
  if (std::isfinite(table.muError))
    text +=
        ", " + filled(Words::tr("estimated error of mu by elements and time steps %1 (%2 %)"),
                      {answerNumber(table.muError, 2), answerNumber(100 * table.relativeError, 2)});
  return text + "\n";
}

}  // namespace

int runMotion(const MotionCommand& command) {
  const Scene scene = loadScene(command.common);
  const PictureSettings settings = checkTableOutputs(command, scene);
  const ColumnChoice columns(command.columns, {"motion"});
  const MotionTable table = compute(scene, command);
  const auto origin = [&] { return motionProvenance("motion", scene, table); };
  writeResult(
      command, settings,
      {.csv = [&] { return provenanceComment(origin()) + columns.select(motionCsv(table)); },
       .json = [&] { return withColumns(motionJson(scene, table), columns); },
       .sheet = [&] { return motionSheet(scene, table); },
       .origin = origin,
       .minTextSize = kMotionText,
       .summary = summaryText(table),
       .reading = readingFacts(scene)});
  return kDone;
}

}  // namespace asperity
