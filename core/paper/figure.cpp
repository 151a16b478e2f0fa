#include "core/paper/figure.h"

#include <array>
#include <nlohmann/json.hpp>

#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/paper/figure_parts.h"
#include "core/scene/provenance.h"
#include "core/scene/scene_file.h"

namespace asperity {
namespace {

constexpr std::array<FigureEntry, 8> kEntries{{
    {FigureName::Contact, "1", "Contact of a rough line and a viscoelastic elastomer",
     R"({"title": "Fig. 1", "surface": {"elements": 1000, "seed": 7},
         "load": {"normal_force": 0.2}})",
     "sweep.velocity_from sweep.velocity_to sweep.points ensemble.realizations", addContactFigure},
    {FigureName::Velocity, "2", "Typical dependence of friction on velocity",
     R"({"title": "Fig. 2"})", "ensemble.realizations", addVelocityFigure},
    {FigureName::Hurst, "3", "Dependence on velocity for six Hurst exponents",
     R"({"title": "Fig. 3", "load": {"normal_force": 10}})", "surface.hurst ensemble.realizations",
     addHurstFigure},
    {FigureName::Forces, "4", "Dependence on velocity for twenty normal forces",
     R"({"title": "Fig. 4", "load": {"normal_force": 0.33}})",
     "load.normal_force ensemble.realizations", addForcesFigure},
    {FigureName::Exponents, "5", "\u03B1 and \u03B2 of Eq. (5) over the Hurst exponent",
     R"({"title": "Fig. 5", "load": {"normal_force": 0.01}})",
     "surface.hurst load.normal_force sweep.velocity_from sweep.velocity_to sweep.points "
     "ensemble.realizations",
     addExponentsFigure},
    {FigureName::Plateau, "6", "Friction on the plateau over the normal force",
     R"({"title": "Fig. 6", "load": {"normal_force": 1}})",
     "surface.hurst load.normal_force sweep.velocity_from sweep.velocity_to sweep.points "
     "ensemble.realizations",
     addPlateauFigure},
    {FigureName::Master, "master", "The master curve of Eqs. (16) and (17)",
     R"({"title": "Master curve", "load": {"normal_force": 0.1}})",
     "load.normal_force surface.length surface.elements surface.rms_height "
     "elastomer.relaxation_time ensemble.realizations",
     addMasterFigure},
    {FigureName::Spacing, "spacing", "What the spacing of the elements does",
     R"({"title": "Influence of the spacing", "load": {"normal_force": 0.1}})",
     "surface.elements ensemble.realizations", addSpacingFigure},
}};

void checkAssignments(const FigureEntry& entry, const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) {
    const std::string key = assignment.substr(0, assignment.find('='));
    if (key == "ensemble.realizations")
      throw InputError("--set", key, "is given to a figure by --realizations");
    if (isOneOf(key, entry.ownKeys))
      throw InputError("--set", key, message("figure {} sets it itself", entry.word));
  }
}

/// Checks that the scene fits: the law and its claims hold for a self-affine line, a Kelvin body
/// and a normal force.
void checkModel(const FigureEntry& entry, const Scene& scene) {
  const auto require = [&](bool fits, const char* key, const char* only) {
    if (!fits)
      throw InputError("--set", key,
                       message("figure {} of the paper is about {}", entry.word, Message(only)));
  };
  require(scene.surface.kind == SurfaceKind::SelfAffine, "surface.kind", "a self_affine line");
  require(scene.elastomer.rheology == Rheology::Kelvin, "elastomer.rheology", "a kelvin body");
  require(scene.elastomer.relaxationTime > 0, "elastomer.relaxation_time",
          "a viscoelastic body: more than 0");
  require(scene.surface.rmsHeight > 0, "surface.rms_height", "a rough line: more than 0");
  require(scene.load.kind == LoadKind::Force, "load.kind", "a constant force");
}

}  // namespace

std::span<const FigureEntry> figureEntries() {
  return kEntries;
}

const FigureEntry& figureEntry(FigureName name) {
  return kEntries[static_cast<std::size_t>(name)];
}

Scene figureScene(FigureName name, const FigureOptions& options) {
  const FigureEntry& entry = figureEntry(name);
  checkAssignments(entry, options.assignments);
  Scene scene = readScene(entry.scene, "--set", {}, options.assignments);
  scene.ensemble.realizations = options.realizations;
  checkModel(entry, scene);
  return scene;
}

Figure makeFigure(FigureName name, const FigureOptions& options) {
  const FigureEntry& entry = figureEntry(name);
  Figure figure;
  figure.name = name;
  figure.scene = figureScene(name, options);
  const bool isOfPaper = name < FigureName::Master;
  figure.sheet.title = isOfPaper ? message("Fig. {}: {}", entry.word, Message(entry.headline))
                                 : Message(entry.headline);
  entry.add(figure, options);
  if (figure.sheet.subtitle.empty()) figure.sheet.subtitle = parameterLine(figure.scene, entry);
  return figure;
}

std::string claimsJson(std::span<const Figure> figures) {
  using Json = nlohmann::ordered_json;
  Json root = {{"schema", "asperity-claims/1"}, {"version", ASPERITY_VERSION}};
  root["paper"] = "Q. Li et al., Phys. Rev. Lett. 111, 034301 (2013)";
  Json list = Json::array(), scenes;
  for (const Figure& figure : figures) {
    const std::string word(figureEntry(figure.name).word);
    scenes[word] = provenance("figure", figure.scene);
    for (const Claim& claim : figure.claims) {
      Json entry = {{"figure", word}};
      entry.update(claimJson(claim));
      list.push_back(std::move(entry));
    }
  }
  root["claims"] = std::move(list);
  root["figures"] = std::move(scenes);
  return jsonFile(root);
}

}  // namespace asperity
