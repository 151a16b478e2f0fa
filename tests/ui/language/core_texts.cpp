#include "tests/ui/language/core_texts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/accuracy/work_precision_sheet.h"
#include "core/base/input_error.h"
#include "core/base/regular_file.h"
#include "core/chart/curve_diagram.h"
#include "core/chart/curve_regions.h"
#include "core/chart/curve_words.h"
#include "core/chart/explanations.h"
#include "core/chart/material_sheets.h"
#include "core/contact/steady_sliding.h"
#include "core/friction/curve_difference.h"
#include "core/friction/ensemble.h"
#include "core/friction/theory_curve.h"
#include "core/material/material_summary.h"
#include "core/paper/figure.h"
#include "core/run/line_diagrams.h"
#include "core/run/motion_table.h"
#include "core/run/steady_frames.h"
#include "core/scene/notes.h"
#include "core/scene/parameters.h"
#include "core/scene/plan.h"
#include "core/scene/scene_check.h"
#include "core/scene/scene_file.h"
#include "core/surface/line_source.h"
#include "core/surface/profile_file.h"

namespace asperity {
namespace {

using Texts = std::set<Message>;

std::vector<Scene> shippedScenes() {
  std::vector<Scene> scenes;
  const std::filesystem::path folder = ASPERITY_RESOURCES_DIR "/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") scenes.push_back(readSceneFile(entry.path()));
  return scenes;
}

/// Effects that no shipped scene has, alone or together.
std::vector<Scene> furtherScenes() {
  const char* changes[] = {R"({"load": {"kind": "indentation", "depth": 1e-6}})",
                           R"({"sliding": {"kind": "step", "velocity": 0, "velocity_after": 1}})",
                           R"({"elastomer": {"rheology": "prony"}})",
                           R"({"surface": {"kind": "profile", "file": "none.csv"}})",
                           R"({"surface": {"roll_off_wavelength": 1000}})",
                           R"({"ensemble": {"realizations": 1}, "sweep": {"points": 1}})"};
  std::vector<Scene> scenes;
  for (const char* change : changes) scenes.push_back(readScene(change, "test"));
  return scenes;
}

void add(Texts& texts, const DiagramSheet& sheet) {
  texts.insert({sheet.title, sheet.subtitle, sheet.note, sheet.status});
  for (const Diagram& diagram : sheet.diagrams) {
    texts.insert({diagram.title, diagram.x.title, diagram.y.title});
    for (const DiagramSeries& series : diagram.series) texts.insert(series.name);
    for (const DiagramSpan& span : diagram.spans) {
      texts.insert(span.label);
      texts.insert(span.notes.begin(), span.notes.end());
    }
    if (diagram.marker) texts.insert({diagram.marker->name, diagram.marker->label});
    texts.insert(diagram.blank);
    for (const DiagramSpan& shade : diagram.shades) texts.insert(shade.label);
    for (const DiagramLabel& label : diagram.labels) texts.insert(label.text);
    if (diagram.ramp) texts.insert({diagram.ramp->title, diagram.ramp->from, diagram.ramp->to});
  }
}

std::vector<CurvePoint> pointsOf(std::int64_t realizations) {
  CurvePoint point;
  point.realizations = realizations;
  return {point};
}

/// A curve that has all four regions.
void addRegions(Texts& texts, Scene scene) {
  scene.accuracy.targetRelativeError = 0;
  scene.surface.elements = 400;
  scene.sweep.points = 41;
  scene.ensemble.realizations = 4;
  const std::vector<CurvePoint> points = frictionCurve(scene).points;
  add(texts, curveSheet(scene, points));
  for (const char* name : {"I", "II", "III", "IV"})
    texts.insert({regionWord(name), regionSentence(name)});
}

/// A curve pinned, one of another setting, and every parameter that may tell two curves apart.
void addComparison(Texts& texts) {
  CurveSet set;
  set.present = {{}, {}, pointsOf(20)};
  set.axes = CurveAxes::Dimensionless;
  for (const Scheme scheme : {Scheme::Nodal, Scheme::Cubic})
    for (const std::int64_t lines : {1, 20}) {
      set.difference = CurveDifference{};
      set.difference->setting = {scheme, 2, lines};
      texts.insert(settingName(set.difference->setting));
      add(texts, curveSheet(set));
    }
  for (const Scene& scene : shippedScenes()) texts.insert(describeDifferences(scene, {}));
}

void addLineDiagrams(Texts& texts) {
  for (Scene scene : shippedScenes()) {
    scene.surface.elements = std::min<std::int64_t>(scene.surface.elements, 400);
    add(texts, spectrumSheet(scene));
    if (scene.sliding.kind != SlidingKind::Steady) continue;
    add(texts, statisticsSheet(SteadyFrames(std::make_shared<const Scene>(scene)).frame(0, 1, 25)));
  }
}

/// Where contact is sought: at all velocities, at some, at all but one, at none.
void addPlansOnLines(Texts& texts) {
  for (const double force : {1e-3, 1.0, 2.0, 4.0, 8.0, 1e3}) {
    Scene scene;
    scene.surface.elements = 64;
    scene.load.normalForce = force;
    scene.sweep = {1e-3, 1, 7};
    for (const PlanStage& stage : planOnLine(scene, Purpose::Curve)) texts.insert(stage.reason);
  }
}

/// On one line and on several.
void addMotion(Texts& texts, Scene scene) {
  scene.surface.elements = 64;
  scene.sliding.duration = 1e-3;
  for (const std::int64_t lines : {1, 2}) {
    MotionOptions options;
    options.lines = scene.surface.kind == SurfaceKind::SelfAffine ? lines : 1;
    add(texts, motionSheet(scene, marchMotion(scene, options)));
  }
}

}  // namespace

Texts tableTexts() {
  Texts texts;
  for (const Parameter& row : parameters()) {
    texts.insert({row.label, row.sentence});
    if (const auto* choice = std::get_if<ChoiceField>(&row.field))
      for (const std::string_view key : choice->choices) {
        std::string word(key);
        std::ranges::replace(word, '_', '-');
        texts.insert(word);
      }
  }
  return texts;
}

Texts explanationTexts() {
  Texts texts;
  for (const HoverExplanation& one : explanations())
    if (!one.sentence.empty()) texts.insert(Message(one.sentence));
  for (const FormulaSymbol& one : formulaSymbols()) texts.insert(Message(one.meaning));
  for (std::size_t i = 0; i < kNotes; ++i) texts.insert(noteSentence(static_cast<Note>(i)));
  for (const TheoryEntry& entry : theoryEntries()) texts.insert(Message(entry.range));
  return texts;
}

Texts sceneTexts() {
  Texts texts;
  for (const Scene& scene : shippedScenes())
    texts.insert({scene.title, scene.chapter, scene.description});
  for (const FigureEntry& entry : figureEntries())  // which open as scenes
    texts.insert(figureScene(entry.name, {}).title);
  return texts;
}

Texts planTexts() {
  Texts texts;
  addPlansOnLines(texts);
  std::vector<Scene> scenes = shippedScenes();
  std::ranges::copy(furtherScenes(), std::back_inserter(scenes));
  for (const Scene& scene : scenes)
    for (const Purpose purpose :
         {Purpose::Curve, Purpose::Picture, Purpose::Surface, Purpose::Window})
      for (const PlanStage& stage : planStages(scene, purpose))
        texts.insert({stage.name, stage.reason});
  return texts;
}

Texts refusalTexts() {
  Texts texts;
  SteadyResult unmet;
  for (const double residual : {0.0, 0.03}) {
    unmet.residual = residual;
    for (const Message& where : {Message(), message("on realization {}", 3)})
      texts.insert(balanceError(unmet, 0.5, where).message());
  }
  const auto refused = [&](const Parameter& row, const auto& give) {
    Scene scene;
    try {
      give(row, scene);
    } catch (const InputError& error) {
      texts.insert(error.message());
    }
  };
  for (const Parameter& row : parameters()) {
    const bool isReal = std::holds_alternative<RealField>(row.field);
    const bool isWhole = std::holds_alternative<IntegerField>(row.field);
    if (!isReal && !isWhole) continue;
    for (const char* text : {"some", "-1e40", "1e40", "1.5e15", "inf", "1e999", "0.5", ""})
      refused(row, [&](const Parameter& p, Scene& scene) { setFromText(p, scene, text); });
  }
  return texts;
}

Texts complaintTexts() {
  Texts texts;
  const auto complaintOf = [&](const auto& act) {
    try {
      act();
      ADD_FAILURE() << "is not refused";
    } catch (const InputError& error) {
      texts.insert(error.message());
    }
  };
  for (const char* scene :
       {R"({"elastomer": {"rheology": "prony", "equilibrium_modulus": 0, "arms": []}})",
        R"({"elastomer": {"rheology": "prony", "equilibrium_modulus": 1e-30}})",
        R"({"elastomer": {"rheology": "standard_solid", "arms": []}})",
        R"({"elastomer": {"rheology": "prony"}, "accuracy": {"scheme": "nodal"}})",
        R"({"interface": {"friction_coefficient": 1, "shear_stress": 1}})",
        R"({"surface": {"slope": 1}})",
        R"({"elastomer": {"viscosity": 1}})",
        R"({"elastomer": {"temperature": 150}})",
        R"({"elastomer": {"temperature": 197}})",
        R"({"surface": {"kind": "profile"}})",
        R"({"accuracy": {"target_relative_error": 0.1,
        "oversampling": 4}})",
        R"({"sweep": {"velocity_from": 2, "velocity_to": 1}})",
        R"([])",
        "",
        "0,1",
        "\xFF\xFEx",
        "\x89PNG",
        R"({"surface": 3})",
        R"({"surface": {"seed": 1, "seed": 2}})",
        R"({"load.depth": 1})",
        R"({"surface": {"length": [1]}})",
        R"({"surface": {"length": {}}})",
        R"({"surface": {"length": true}})",
        R"({"surface": {"length": "x"}})",
        R"({"surface": {"lenght": 1}})",
        R"({"elastomer": {"rheology": "prony", "arms": [1]}})",
        R"({"elastomer": {"rheology": "prony", "arms": [{"modulus": 1}]}})",
        R"({"a": {"a": {"a": {"a": {"a": {"a": {"a": {"a": {"a": 1}}}}}}}}})"})
    complaintOf([&] {
      Scene read = readScene(scene, "test");
      checkEffects(read);
    });
  const auto line = [&](const char* scene) {
    complaintOf([&] { LineSource(readScene(scene, "test"), 8); });
  };
  line(R"({"surface": {"elements": 16777216, "kind": "sine"}})");
  line(R"({"surface": {"kind": "sine", "waves": 100, "elements": 50}})");
  Scene sinks;
  sinks.elastomer.rheology = Rheology::Prony;
  sinks.elastomer.equilibriumModulus = 0;
  complaintOf([&] { requireEquilibrium(sinks); });
  for (const SlidingKind kind :
       {SlidingKind::Start, SlidingKind::Step, SlidingKind::Oscillation, SlidingKind::Reversal}) {
    Scene moving;
    moving.sliding.kind = kind;
    complaintOf([&] { curveDifference(moving, {}, {}); });
  }
  Scene aimed;
  aimed.accuracy.targetRelativeError = 0.01;
  complaintOf([&] { curveDifference(aimed, {}, {}); });
  for (const char* profile :
       {"1\n2\n", "1\n2\nx\n", "1\n2\ninf\n", "1\n2\n1e30\n", "1,2\n2\n", "0,1\n0,2\n0,3\n",
        "0,1\n1,2\n3,3\n", "x,1\n1,2\n", "x (mm)\n1\n", "1,000\n2,000\n", "0;1,5\n", "PK\3\4"})
    complaintOf([&] { parseProfile(profile, {}); });
  return texts;
}

Texts figureTexts() {
  Texts texts;
  for (const FigureEntry& entry : figureEntries()) {
    FigureOptions options;
    options.realizations = 2;
    // The curve of the paper's algorithm takes more time than all other figures.
    if (entry.name == FigureName::Velocity) options.assignments = {"surface.elements=1000"};
    const Figure figure = makeFigure(entry.name, options);
    texts.insert({entry.headline, figure.scene.title});
    add(texts, figure.sheet);
    for (const Claim& claim : figure.claims)
      texts.insert(
          {claim.where, claim.claim, claim.quantity, claim.criterion, claim.note, claim.scheme});
  }
  return texts;
}

/// A rubber as measured, and where a scene uses it.
void addMaterials(Texts& texts) {
  const std::string file = "epdm_70.csv";
  const std::string folder = ASPERITY_RESOURCES_DIR "/materials/measurements/";
  const Material material = makeMaterial(readRegularFile(folder + file, 1 << 20), file, {});
  for (const NamedSheet& sheet : materialSheets(material)) add(texts, sheet.sheet);
  for (const Message& line : materialSummary(material)) texts.insert(line);
  const Scene scene = readScene(R"({"elastomer": {"material": "epdm_70"}})", "test");
  add(texts, excitationSheet(scene));
}

Texts diagramTexts() {
  Texts texts;
  for (Scene& scene : shippedScenes()) {
    if (scene.sliding.kind == SlidingKind::Steady)
      for (const std::int64_t realizations : {1, 20})
        add(texts, curveSheet(scene, pointsOf(realizations)));
    else
      addMotion(texts, scene);
  }
  Scene scene;
  scene.surface.elements = 64;
  scene.sweep.points = 5;
  scene.accuracy.targetRelativeError = 0.01;
  WorkPrecisionOptions options;
  options.lines = 2;
  options.repeats = 1;
  const WorkPrecision comparison = workPrecision(scene, options);
  add(texts, workPrecisionSheet(comparison));
  add(texts, standardErrorSheet(comparison));
  add(texts, curveSheet(scene, pointsOf(20)));
  addRegions(texts, scene);
  addComparison(texts);
  addLineDiagrams(texts);
  addMaterials(texts);
  return texts;
}

}  // namespace asperity
