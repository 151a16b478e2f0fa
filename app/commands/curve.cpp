// asperity curve: friction over velocity or any other key, averaged over the scene's realizations.
#include <algorithm>
#include <cmath>

#include "app/command_line.h"
#include "app/output.h"
#include "app/pictures/picture_composer.h"
#include "app/result_files.h"
#include "core/accuracy/compute_curve.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/chart/curve_diagram.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/scene/data_table.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_check.h"
#include "core/scene/sweep.h"
#include "core/surface/measured_summary.h"
#include "ui/language/language.h"

namespace asperity {
namespace {

std::string axisText(const Curve& curve, const Scene& scene) {
  const std::size_t points = curve.points.size();
  if (!scene.sweep.isOfVelocity())
    return points == 1
               ? filled(Words::tr("one value of %1"), {scene.sweep.key})
               : filled(Words::tr("%1 values of %2"), {std::to_string(points), scene.sweep.key});
  return points == 1 ? Words::tr("one velocity")
                     : filled(Words::tr("%1 velocities"), {std::to_string(points)});
}

/// Returns the lines of the summary. `set`: the same curve with the comparisons beside it.
std::string summaryText(const Curve& curve, const CurveSet& set) {
  const Scene& scene = set.present.scene;
  const std::int64_t lines = curve.points.front().realizations;
  std::string text = axisText(curve, scene) + ", " +
                     (lines == 1 ? Words::tr("one realization")
                                 : filled(Words::tr("%1 realizations"), {std::to_string(lines)}));
  if (curve.marginalFraction > 0)
    text += ", " + filled(Words::tr("%1 % of the balances with a partly loaded element"),
                          {answerNumber(100 * curve.marginalFraction, 2)});
  text += "\n";
  if (std::isfinite(curve.achievedError))
    text +=
        filledLine(curve.isTargetMet
                       ? Words::tr("relative error at most %1 at every velocity, target met")
                       : Words::tr("relative error at most %1 at every velocity, target not met"),
                   answerNumber(curve.achievedError, 2));
  const auto unresolved = std::ranges::count_if(curve.points, [](const CurvePoint& point) {
    return pointNoteSet(point).has(Note::UnresolvedFriction);
  });
  // A curve over the width has no width of its own.
  if (scene.sweep.key != "load.width")
    text += translatedLine(pressureNote(curve.points, scene.load.width));
  for (const MeasuredCurve& measured : set.measured)
    text += translatedLines(notesOf({&measured.data, 1}));
  text += translatedLines(set.notes);
  NoteSet notes;
  for (const CurvePoint& point : curve.points) notes.add(point.notes);
  text += noteLines(notes);
  if (unresolved == 1)
    text += Words::tr(
                "at one velocity friction is below what the elements resolve, see the "
                "column notes") +
            "\n";
  if (unresolved > 1)
    text += filledLine(
        Words::tr("at %1 velocities friction is below what the elements resolve, see the "
                  "column notes"),
        unresolved);
  return text;
}

/// Returns the table of the curve, or of all curves where there are more, after a comment with its
/// provenance.
std::string csvText(const CurveSet& set, const CurveArguments& arguments,
                    const ColumnChoice& columns) {
  const Scene& scene = set.present.scene;
  nlohmann::ordered_json origin = provenance("curve", scene);
  if (!arguments.hasMore(scene))
    return provenanceComment(origin) +
           columns.select(curveCsv(set.present.points, columnsFor(scene, showsForces(set))));
  arguments.addTo(origin);
  return provenanceComment(origin) + columns.select(curveSetCsv(set));
}

std::string jsonText(const CurveSet& set, const CurveArguments& arguments,
                     const ColumnChoice& columns) {
  const Scene& scene = set.present.scene;
  const std::string own = curveJson(set.present.points, scene, showsForces(set));
  if (!arguments.hasMore(scene)) return withColumns(own, columns);
  auto answer = jsonValue(own);
  addCurvesTo(answer, set);
  return withColumns(jsonFile(answer), columns);
}

void writeRealizations(const CurveCommand& command, const Scene& scene,
                       const RealizationTable& lines) {
  const std::string& file = command.realizationTable;
  nlohmann::ordered_json given = optionsFor(command.common.given, file);
  given.erase("columns");  // they are those of the curve
  given["output_option"] = "realizations-table";
  const ProvenanceOptions options(std::move(given));
  if (fileExtension(file) == ".csv") {
    writeFileAtomically(file, provenanceComment("curve", scene) + tableCsv(lines.table()));
    return;
  }
  nlohmann::ordered_json answer = provenance("curve", scene);
  answer["rows"] = tableJson(lines.table());
  writeFileAtomically(file, jsonFile(answer));
}

/// Checks the file of the table of realizations, which only curves of given lines have.
void checkRealizations(const CurveCommand& command, const Scene& scene) {
  constexpr const char* kOption = "--realizations-table";
  const std::string& file = command.realizationTable;
  if (file.empty()) return;
  requireVelocityAxis(scene, kOption);
  if (choosesAccuracy(scene))
    throw InputError("", kOption,
                     "needs the same lines at every velocity; with "
                     "accuracy.target_relative_error each has its own");
  checkOutputs({file}, {".csv", ".json"});
  checkNoInput(file, inputFiles(command.common, scene));
  checkNoInput(file, filesReadBeside(command.curves, scene));
  if (std::ranges::find(command.outputs, file) != command.outputs.end())
    throw InputError("", kOption, file + " is --output, too");
}

}  // namespace

int runCurve(const CurveCommand& command) {
  const ComparedScene compared = withCurveOptions(loadScene(command.common), command.curves);
  const Scene& scene = compared.scene;
  withSceneContext(command.common, [&] { requireSteadySliding(scene, "asperity curve"); });
  const PictureSettings settings = checkTableOutputs(command, scene);
  for (const std::string& output : command.outputs)
    checkNoInput(output, filesReadBeside(command.curves, scene));
  checkUseful(command.curves, command.outputs);
  const ColumnChoice columns(command.columns, {"curve", "curves"});
  checkRealizations(command, scene);
  checkCurves(command.curves, scene);
  if (!std::ranges::all_of(command.outputs, isTableFile))
    withSceneContext(command.common, [&] {
      const DiagramSheet planned = curveSheet(plannedCurveSet(command.curves, compared));
      checkPlannedPanels(styled(planned, styleOfPlan(settings.style)), settings, 0);
    });
  findLinesWithProgress(scene, command.common.quiet);
  RealizationTable lines(sweepVelocities(scene.sweep));
  const bool keepsLines = !command.realizationTable.empty();
  const Curve curve = withSceneContext(command.common, [&] {
    return computeCurve(scene, command.common, keepsLines ? &lines : nullptr);
  });
  const ComputedCurves curves = withSceneContext(command.common, [&] {
    return makeCurveSet(command.curves, compared, curve, command.common);
  });
  const CurveSet& set = curves.set;
  TableResult result{.csv = [&] { return csvText(set, command.curves, columns); },
                     .json = [&] { return jsonText(set, command.curves, columns); },
                     .sheet =
                         [&] {
                           DiagramSheet sheet = curveSheet(set);
                           checkPanels(styled(sheet, settings.style), settings, 0);
                           return sheet;
                         },
                     .origin = [&] { return provenance("curve", scene); },
                     .summary = summaryText(curve, set),
                     .reading = readingFacts(scene)};
  command.curves.addTo(result.picture);
  if (keepsLines)
    result.otherFiles = {
        {command.realizationTable, [&] { writeRealizations(command, scene, lines); }}};
  writeResult(command, settings, result);
  curves.requireTargets();
  return kDone;
}

}  // namespace asperity
