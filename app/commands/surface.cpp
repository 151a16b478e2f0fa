// asperity surface: the rigid line of a scene, its spectrum and its statistics.
#include <fmt/format.h>

#include "app/command_line.h"
#include "app/headless_pictures.h"
#include "app/output.h"
#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/run/line_diagrams.h"
#include "core/scene/provenance.h"
#include "core/surface/line_source.h"
#include "core/surface/surface_file.h"
#include "ui/chart/diagram_picture.h"
#include "ui/draw/png_file.h"
#include "ui/draw/ticks.h"
#include "ui/language/translated.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

std::string summaryOf(const Line& line, const std::vector<std::string>& outputs) {
  const auto number = [](double value) { return shortNumber(value, 6); };
  std::string text = filled(Words::tr("length %1 m, %2 points, rms height %3 m, rms slope %4"),
                            {number(line.length), std::to_string(line.nodes()),
                             number(line.rmsHeight), number(line.rmsSlope)}) +
                     "\n";
  for (const std::string& output : outputs) text += wroteLine(output);
  return text;
}

void writePicture(const std::string& output, const Scene& scene, const Line& line) {
  constexpr int kWidth = 1280, kHeight = 800;
  HeadlessPictures pictures;
  pictures.write(output, composeDiagrams(surfaceSheet(scene, line), {kWidth, kHeight}),
                 {translated(scene.title), pictureOrigin("surface", scene)});
  pictures.finish();
}

void writeSurface(const std::string& output, const Scene& scene, const LineSource& source,
                  const Line& line) {
  const std::string extension = extensionOf(output);
  if (extension == ".csv")
    writeFileAtomically(output, provenanceComment("surface", scene) + lineCsv(line));
  if (extension == ".json") writeFileAtomically(output, surfaceJson(scene, source, line));
  if (extension == ".png") writePicture(output, scene, line);
}

}  // namespace

int runSurface(const SurfaceCommand& command) {
  const Scene scene = sceneOf(command.common);
  checkOutputs(command.outputs, {".csv", ".json", ".png"});
  for (const std::string& output : command.outputs)
    checkNoInput(output, inputsOf(command.common, scene));
  withSceneContext(command.common, [&] {
    const LineSource source(scene, pointsPerElement(scene));
    const Line line = source.make(0);
    for (const std::string& output : command.outputs) writeSurface(output, scene, source, line);
    printSummary(command.common.json, command.common.quiet, summaryOf(line, command.outputs));
    if (command.common.json) fmt::print("{}", surfaceJson(scene, source, line));
  });
  return kDone;
}

}  // namespace asperity
