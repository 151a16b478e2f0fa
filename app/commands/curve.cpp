// asperity curve: friction over velocity, averaged over the scene's realizations.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/command_line.h"
#include "app/headless_pictures.h"
#include "app/output.h"
#include "app/picture_composer.h"
#include "app/surface_progress.h"
#include "core/accuracy/compute_curve.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/chart/curve_diagram.h"
#include "core/friction/curve_file.h"
#include "core/friction/ensemble.h"
#include "core/scene/effects.h"
#include "core/scene/provenance.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/ticks.h"
#include "ui/language/translated.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

void writePictures(const CurveCommand& command, const CurveSet& set,
                   const PictureSettings& settings) {
  const std::vector<std::string>& outputs = command.outputs;
  const auto isPicture = [](const std::string& output) {
    return extensionOf(output) != ".csv" && extensionOf(output) != ".json";
  };
  if (std::none_of(outputs.begin(), outputs.end(), isPicture)) return;
  DiagramOptions options{settings.width, settings.height, settings.scale, settings.theme};
  if (settings.transparent) options.theme.background.a = 0;
  const DiagramSheet sheet = curveSheet(set);
  checkPanels(sheet, settings, 0);
  const DrawList list = composeDiagrams(sheet, options);
  nlohmann::ordered_json origin = provenance("curve", set.present.scene);
  origin["picture"] = settings.json();
  command.curves.addTo(origin["picture"]);
  HeadlessPictures pictures(settings.backend);
  for (const std::string& output : outputs)
    if (isPicture(output))
      pictures.write(output, list,
                     {translated(sheet.title), provenanceLine(origin), settings.scale});
  pictures.finish();
}

std::string summaryOf(const Curve& curve, const std::vector<std::string>& outputs) {
  const std::int64_t lines = curve.points.front().realizations;
  const std::size_t velocities = curve.points.size();
  std::string text =
      (velocities == 1 ? Words::tr("one velocity")
                       : filled(Words::tr("%1 velocities"), {std::to_string(velocities)})) +
      ", " +
      (lines == 1 ? Words::tr("one realization")
                  : filled(Words::tr("%1 realizations"), {std::to_string(lines)}));
  if (curve.marginalFraction > 0)
    text += ", " + filled(Words::tr("%1 % of the balances with a partly loaded element"),
                          {shortNumber(100 * curve.marginalFraction, 2)});
  text += "\n";
  if (std::isfinite(curve.achievedError))
    text += filled(curve.isTargetMet
                       ? Words::tr("relative error at most %1 at every velocity, target met")
                       : Words::tr("relative error at most %1 at every velocity, target not met"),
                   {shortNumber(curve.achievedError, 2)}) +
            "\n";
  const auto unresolved = std::ranges::count_if(curve.points, [](const CurvePoint& point) {
    return noteSetOf(point).has(Note::UnresolvedFriction);
  });
  const CurvePoint& first = curve.points.front();
  if (std::isfinite(first.normalForce))
    text += filled(Words::tr("F_N = %1 N on one period; results depend on the width"),
                   {shortNumber(first.normalForce, 6)}) +
            "\n";
  NoteSet notes;
  for (const CurvePoint& point : curve.points) notes.add(point.notes);
  for (const Note note : notes.list())
    text += std::string(wordOf(note)) + ": " + translated(sentenceOf(note)) + "\n";
  if (unresolved > 0)
    text +=
        filled(Words::tr("at %1 velocities friction is below what the elements resolve, see the "
                         "column notes"),
               {std::to_string(unresolved)}) +
        "\n";
  for (const std::string& output : outputs) text += wroteLine(output);
  return text;
}

/// Returns one table of all curves where there are more than the scene's own.
std::string tableOf(const CurveSet& set, const CurveArguments& arguments) {
  return arguments.hasMore(set.present.scene) ? curveSetCsv(set) : curveCsv(set.present.points);
}

std::string jsonOf(const CurveSet& set, const CurveArguments& arguments) {
  const std::string own = curveJson(set.present.points, set.present.scene);
  if (!arguments.hasMore(set.present.scene)) return own;
  auto answer = nlohmann::ordered_json::parse(own);
  addCurvesTo(answer, set);
  return answer.dump(2) + "\n";
}

std::string commentOf(const CurveSet& set, const CurveArguments& arguments) {
  if (!arguments.hasMore(set.present.scene)) return provenanceComment("curve", set.present.scene);
  nlohmann::ordered_json origin = provenance("curve", set.present.scene);
  arguments.addTo(origin);
  return "# asperity: " + provenanceLine(origin) + "\n";
}

}  // namespace

int runCurve(const CurveCommand& command) {
  const ComparedScene compared = withComparisons(sceneOf(command.common), command.curves);
  const Scene& scene = compared.scene;
  withSceneContext(command.common, [&] { needSteadySliding(scene, "asperity curve"); });
  checkOutputs(command.outputs, {".csv", ".json", ".png", ".svg", ".pdf"}, Without::PrintsTable);
  for (const std::string& output : command.outputs)
    checkNoInput(output, inputsOf(command.common, scene));
  checkUseful(command.picture, command.outputs);
  checkUseful(command.curves, command.outputs);
  const PictureSettings settings = pictureSettings(command.picture, {1200, 800, "print"});
  checkCurves(command.curves, scene);
  findLinesWithProgress(scene, command.common.quiet);
  const Curve curve =
      withSceneContext(command.common, [&] { return computeCurve(scene, command.common); });
  const CurveSet set = withSceneContext(command.common, [&] {
    return curvesOf(command.curves, compared, curve.points, command.common);
  });
  for (const std::string& output : command.outputs) {
    const std::string extension = extensionOf(output);
    if (extension == ".csv")
      writeFileAtomically(output, commentOf(set, command.curves) + tableOf(set, command.curves));
    if (extension == ".json") writeFileAtomically(output, jsonOf(set, command.curves));
  }
  writePictures(command, set, settings);
  const bool tableOnStdout = command.outputs.empty();
  if (command.common.json)
    fmt::print("{}", jsonOf(set, command.curves));
  else if (tableOnStdout)
    fmt::print("{}", tableOf(set, command.curves));
  if (!tableOnStdout)
    printSummary(command.common.json, command.common.quiet, summaryOf(curve, command.outputs));
  requireTarget(curve);
  return kDone;
}

}  // namespace asperity
