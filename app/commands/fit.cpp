// asperity fit: parameters of a scene that fit measured friction, with their errors.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/command_line.h"
#include "app/command_options.h"
#include "app/output.h"
#include "app/output_folder.h"
#include "app/progress_bar.h"
#include "core/accuracy/compute_curve.h"
#include "core/base/input_error.h"
#include "core/base/number_text.h"
#include "core/chart/comparison.h"
#include "core/chart/fit_report.h"
#include "core/scene/effects.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"
#include "core/scene/sweep.h"
#include "ui/draw/ticks.h"
#include "ui/language/translated.h"
#include "ui/language/words.h"

namespace asperity {
namespace {

constexpr PictureDefaults kPictures{1200, 900, "print"};

/// KEY or KEY=LOW:HIGH.
VariedParameter variedFrom(const std::string& text, const Scene& scene) {
  const std::size_t equals = text.find('=');
  const std::string key = text.substr(0, equals);
  if (equals == text.npos) return {key, scene};
  const std::string range = text.substr(equals + 1);
  const std::size_t colon = range.find(':');
  double low = 0, high = 0;
  if (colon == range.npos || !readNumber(std::string_view(range).substr(0, colon), low) ||
      !readNumber(std::string_view(range).substr(colon + 1), high))
    throw InputError("", "--vary", message("'{}' is not KEY or KEY=LOW:HIGH", text));
  return {key, scene, low, high};
}

std::vector<VariedParameter> variedFrom(const std::vector<std::string>& texts, const Scene& scene) {
  std::vector<VariedParameter> varied;
  for (const std::string& text : texts) {
    varied.push_back(variedFrom(text, scene));
    for (std::size_t i = 0; i + 1 < varied.size(); ++i)
      if (varied[i].key() == varied.back().key())
        throw InputError("", "--vary", message("{} is given more than once", varied.back().key()));
  }
  return varied;
}

/// The scene with the names of its files as they are seen from another folder.
Scene seenFrom(const std::string& folder, Scene scene) {
  const auto move = [&](std::string& name) {
    const std::filesystem::path file = scene.folder / name;
    std::error_code error;
    if (name.empty() || !std::filesystem::exists(file, error)) return;  // a shipped material
    const std::filesystem::path seen = std::filesystem::proximate(file, folder, error);
    if (!error) name = seen.string();
  };
  if (hasSurfaceFile(scene.surface)) move(scene.surface.file);
  move(scene.elastomer.material);
  for (DataFile& table : scene.comparison.data) move(table.file);
  return scene;
}

std::string summaryOf(const Fit& fit) {
  std::string text;
  for (const FittedParameter& parameter : fit.parameters)
    text += translated(fittedInWords(parameter)) + "\n";
  text += filled(Words::tr("chi squared %1 for %2 degrees of freedom"),
                 {shortNumber(fit.chiSquared, 4), std::to_string(fit.freedom)}) +
          "\n";
  for (const Message& note : fit.notes) text += translated(note) + "\n";
  return text;
}

}  // namespace

int runFit(const FitCommand& command) {
  checkFolderName(command.output);
  const PictureSettings settings = pictureSettings(command.picture, kPictures);
  Scene scene = sceneOf(command.common);
  CurveArguments beside;
  beside.data = command.data;
  scene = withCurveOptions(scene, beside);
  if (scene.comparison.data.empty())
    throw InputError("", "--data", "no measured friction is given, nor named by the scene");
  return withSceneContext(command.common, [&] {
    needSteadySliding(scene, "asperity fit");
    needVelocityAxis(scene, "asperity fit");
    if (choosesAccuracy(scene))
      throw InputError("", "accuracy.target_relative_error",
                       "a fit needs the same lines everywhere, not a target");
    const std::vector<VariedParameter> varied = variedFrom(command.varied, scene);
    const std::vector<FrictionData> data = readComparisonData(scene);
    std::vector<std::filesystem::path> inputs = inputsOf(command.common, scene);
    for (const DataFile& table : scene.comparison.data) inputs.push_back(scene.folder / table.file);
    FitOptions options;
    options.threads = command.common.threads;
    options.hasProfiles = !command.withoutProfiles;
    ProgressBar bar(Words::tr("evaluations"), command.common.quiet);
    options.progress = [&bar](int evaluations, double) {
      constexpr int kUsual = 150;
      bar.show(std::min(evaluations, kUsual - 1), kUsual);
    };
    const Fit fit = fitFriction(scene, data, varied, options);
    CurveSet set;
    set.present = {{}, fit.scene, computeCurve(fit.scene, command.common).points, 0};
    StateOptions states;
    states.threads = command.common.threads;
    addComparisons(set, data, states);

    nlohmann::ordered_json answer = provenance("fit", fit.scene);
    answer["vary"] = command.varied;
    answer["fit"] = fitJson(fit);
    OutputFolder output(command.output, inputs, settings);
    output.addText("fit.json", answer.dump(2) + "\n");
    output.addText("fitted.scene.json", writeScene(seenFrom(command.output, fit.scene)));
    output.addText("fit.csv", provenanceComment("fit", fit.scene) + fitCsv(fit, data));
    output.addSheet("curve", fitSheet(fit, set));
    if (!fit.profiles.empty()) output.addSheet("profiles", profileSheet(fit));
    nlohmann::ordered_json origin = provenance("fit", fit.scene);
    origin["picture"] = settings.json();
    output.write(provenanceLine(origin));
    printSummary(command.common.json, command.common.quiet, summaryOf(fit) + output.summary());
    if (command.common.json) fmt::print("{}\n", answer.dump(2));
    return kDone;
  });
}

}  // namespace asperity
