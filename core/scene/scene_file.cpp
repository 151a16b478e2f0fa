#include "core/scene/scene_file.h"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/base/text_number.h"
#include "core/material/material_library.h"
#include "core/scene/parameters.h"
#include "core/scene/scene_check.h"
#include "core/scene/sweep.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kSchema = "asperity-scene/1";
constexpr int kDeepestScene = 8, kDeepestMaterial = 8;
constexpr std::string_view kSceneIsNeeded =
    "a scene is JSON in UTF-8; a measured surface is a file that a scene names as surface.file, "
    "with surface.kind measured";

/// A value of the file or of --set, on its way to its row.
struct Assignment {
  std::string key;
  ParameterValue value;
  bool typed = true;  // false: text from --set, still to be read as a number
  bool fromFile = true;
};

ParameterValue valueFrom(const std::string& key, const Json& json) {
  const Parameter& row = knownParameter(key);
  if (json.is_number_unsigned() && json.get<std::uint64_t>() > std::uint64_t{1} << 62)
    return json.get<double>();
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  if (json.is_array() && isList(row)) return jsonLine(json);
  const Message given = json.is_object()  ? Message("an object")
                        : json.is_array() ? Message("a list")
                                          : Message::name(jsonLine(json));
  throw InputError("", key,
                   message("{} is not allowed here; allowed is {}", given, allowedText(row)));
}

void checkSchema(const Json& schema) {
  if (!schema.is_string() || schema.get<std::string>() != kSchema)
    throw InputError(
        "", "schema",
        message("{} is not {}",
                shortened(schema.is_string() ? schema.get<std::string>() : jsonLine(schema)),
                kSchema));
}

bool isSection(const std::string& name) {
  const std::string start = name + ".";
  return std::ranges::any_of(parameters(),
                             [&](const Parameter& row) { return row.key.starts_with(start); });
}

/// Returns the value of a key. Only sections are objects, so an object under another name is a
/// section with a mistake in its name.
Assignment assignmentFrom(const std::string& key, const Json& value) {
  if (value.is_object() && !findParameter(key)) throw unknownKey(key, nearestSection(key));
  return {key, valueFrom(key, value)};
}

void flattenSection(const std::string& section, const Json& members,
                    std::vector<Assignment>& assignments) {
  if (!members.is_object()) throw InputError("", section, "needs an object of keys");
  for (const auto& [member, inner] : members.items()) {
    const std::string key = section + "." + member;
    if (isSection(key))
      flattenSection(key, inner, assignments);
    else
      assignments.push_back(assignmentFrom(key, inner));
  }
}

std::vector<Assignment> flatten(const Json& root) {
  if (!root.is_object()) throw InputError("", "", "a scene is one JSON object");
  std::vector<Assignment> assignments;
  for (const auto& [name, value] : root.items()) {
    if (name == "schema") {
      checkSchema(value);
    } else if (isSection(name)) {
      flattenSection(name, value, assignments);
    } else if (name.find('.') != std::string::npos) {
      throw InputError("", shortened(name),
                       "a key of a section stands inside its section's object");
    } else {
      assignments.push_back(assignmentFrom(name, value));
    }
  }
  return assignments;
}

Assignment parseAssignment(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("--set", "", message("'{}' is not KEY=VALUE", shortened(text)));
  Assignment assignment{text.substr(0, equals), text.substr(equals + 1), false, false};
  knownParameter(assignment.key);
  return assignment;
}

bool isKind(const Assignment& assignment) {
  return isKind(knownParameter(assignment.key));
}

/// Returns the row with the unit in which it may be typed. Its limits stay: what the swept key
/// allows is checked when the scene is complete.
Parameter asTyped(const Parameter& row, const Scene& scene) {
  Parameter typed = parameterIn(row, scene);
  typed.field = row.field;
  return typed;
}

void apply(const Assignment& assignment, Scene& scene) {
  const Parameter& row = knownParameter(assignment.key);
  if (assignment.typed)
    setValue(row, scene, assignment.value);
  else
    setFromText(asTyped(row, scene), scene, std::get<std::string>(assignment.value));
}

std::string withCommas(std::string_view words) {
  std::string list(words);
  replaceAll(list, " ", ", ");
  return list;
}

void refuseOtherKind(const Parameter& row, const Scene& scene) {
  const Parameter* decides = findParameter(row.applies.choiceKey);
  // A choice that has no meaning itself cannot be named as what is missing.
  const Parameter* of = &row;
  for (; !isApplicable(*decides, scene); decides = findParameter(decides->applies.choiceKey))
    of = decides;
  const Parameter& choice = *decides;
  const std::string word = std::get<std::string>(parameterValue(choice, scene));
  throw InputError(
      "", std::string(row.key),
      of->applies.isExcept
          ? message("has no meaning for {} {}; it belongs to all others", choice.key, word)
          : message("has no meaning for {} {}; it belongs to {}", choice.key, word,
                    withCommas(of->applies.words)));
}

/// Returns whether --set has changed a kind on which the row depends, directly or by another
/// choice.
bool dependsOn(const std::set<std::string_view>& changedKinds, const Parameter& row) {
  for (const Applicability& applies : {row.applies, row.alsoApplies})
    if (!applies.choiceKey.empty() && (changedKinds.contains(applies.choiceKey) ||
                                       dependsOn(changedKinds, *findParameter(applies.choiceKey))))
      return true;
  return false;
}

/// Returns whether it sets one point per element, which nodal elements have anyway.
bool isHarmless(const Assignment& assignment) {
  if (assignment.key != "accuracy.oversampling") return false;
  Scene ignored;
  apply(assignment, ignored);
  return ignored.accuracy.oversampling <= 1;
}

constexpr std::string_view kTarget = "accuracy.target_relative_error";

bool isResolution(const Assignment& assignment) {
  return isSetByTarget(knownParameter(assignment.key));
}

bool isTarget(const Assignment& assignment) {
  if (assignment.key != kTarget) return false;
  Scene scene;
  apply(assignment, scene);
  return scene.accuracy.targetRelativeError > 0;
}

/// A target chooses the resolution, so only one of the two may be stated. --set wins over the file.
void chooseAccuracy(std::vector<Assignment>& assignments) {
  const auto has = [&](bool fromFile, bool (*is)(const Assignment&)) {
    return std::any_of(assignments.begin(), assignments.end(), [&](const Assignment& assignment) {
      return assignment.fromFile == fromFile && is(assignment);
    });
  };
  const auto drop = [&](bool (*is)(const Assignment&)) {
    std::erase_if(assignments, [&](const Assignment& assignment) {
      return assignment.fromFile && is(assignment);
    });
  };
  for (const bool fromFile : {true, false})
    if (has(fromFile, isTarget) && has(fromFile, isResolution))
      throw InputError("", "accuracy.target_relative_error",
                       "chooses scheme and oversampling itself; give it or them");
  if (has(false, isTarget)) drop(isResolution);
  if (has(false, isResolution)) drop(isTarget);
}

constexpr std::string_view kRheology = "elastomer.rheology";

/// Members of a material file that describe it for people, and its own history.
constexpr std::string_view kMaterialRemarks[]{"schema", "verb",   "version",     "name",
                                              "source", "origin", "measurement", "fit"};

/// Returns the last assignment to a key; null where there is none.
const Assignment* lastValue(const std::vector<Assignment>& assignments, std::string_view key) {
  const auto found =
      std::ranges::find(assignments.rbegin(), assignments.rend(), key, &Assignment::key);
  return found == assignments.rend() ? nullptr : &*found;
}

std::string nameOfMaterial(const std::vector<Assignment>& assignments) {
  const Assignment* named = lastValue(assignments, kMaterialKey);
  const auto* name = named ? std::get_if<std::string>(&named->value) : nullptr;
  return name ? *name : std::string();
}

/// Returns the values of a material as keys of the scene's elastomer, without those that only
/// describe the material (source, quality of the fit).
std::vector<Assignment> materialValues(const std::string& name,
                                       const std::filesystem::path& folder) {
  const MaterialText material = readMaterialText(name, folder);
  try {
    const Json root = parseJson(material.json, kDeepestMaterial,
                                "a material is JSON in UTF-8, which 'asperity material' makes from "
                                "a table of measured moduli");
    if (!root.is_object() || !root.contains("schema") || root["schema"] != kMaterialSchema)
      throw InputError("", "schema", message("is not {}", kMaterialSchema));
    std::vector<Assignment> values;
    for (const auto& [key, value] : root.items()) {
      const std::string path = "elastomer." + key;
      const Parameter* row = findParameter(path);
      if (isSection(path))
        flattenSection(path, value, values);
      else if (row && row->rule.isOfMaterial)
        values.push_back({path, valueFrom(path, value)});
      else if (std::ranges::find(kMaterialRemarks, key) == std::end(kMaterialRemarks))
        throw InputError("", shortened(key), "unknown key of a material");
    }
    for (const char* needed : {"elastomer.equilibrium_modulus", "elastomer.arms"})
      if (!lastValue(values, needed)) throw InputError("", needed + 10, "is missing");
    // Each value is checked here, where an error can name the material's file.
    Scene ignored;
    for (const Assignment& value : values) apply(value, ignored);
    return values;
  } catch (const InputError& error) {
    throw error.in(material.name);
  }
}

/// Returns whether the scene itself states everything that the material would give. Its file is
/// then not needed, and the scene does not change when the material does.
bool isWholeWithoutMaterial(const std::vector<Assignment>& assignments, const Scene& scene) {
  return std::ranges::all_of(parameters(), [&](const Parameter& row) {
    return !row.rule.isOfMaterial || !isApplicable(row, scene) || lastValue(assignments, row.key);
  });
}

/// A material implies a Prony series. One from --set replaces the rheology of the file and all
/// values that a material gives.
void chooseMaterial(std::vector<Assignment>& assignments, Scene& scene,
                    std::set<std::string_view>& changedKinds) {
  const auto namesMaterial = [](const Assignment& assignment) {
    return assignment.key == kMaterialKey && assignment.value != ParameterValue(std::string());
  };
  if (std::ranges::none_of(assignments, namesMaterial)) return;
  const Assignment& last = *lastValue(assignments, kMaterialKey);
  if (!last.fromFile && namesMaterial(last)) {
    std::erase_if(assignments, [](const Assignment& assignment) {
      return assignment.fromFile &&
             (assignment.key == kRheology || knownParameter(assignment.key).rule.isOfMaterial);
    });
    changedKinds.insert({kRheology, "elastomer.shift.kind"});
  }
  scene.elastomer.rheology = Rheology::Prony;
}

/// Inserts the values of a material before those that the scene states, which override them.
void addMaterialValues(std::vector<Assignment>& assignments, Scene& scene,
                       const std::filesystem::path& folder) {
  const std::string name = nameOfMaterial(assignments);
  if (name.empty() || scene.elastomer.rheology != Rheology::Prony) return;
  if (lastValue(assignments, "elastomer.shift.kind") && isWholeWithoutMaterial(assignments, scene))
    return;
  std::vector<Assignment> values = materialValues(name, folder);
  std::erase_if(values, [&](const Assignment& value) { return lastValue(assignments, value.key); });
  for (const Assignment& value : values)
    if (isKind(value)) apply(value, scene);
  // A key beside the material may choose another shift, for which the material's has no meaning.
  std::erase_if(values, [&](const Assignment& value) {
    return isKind(value) || !isApplicable(knownParameter(value.key), scene);
  });
  assignments.insert(assignments.begin(), values.begin(), values.end());
}

/// Returns whether the file asks for "every row" of a surface that --set has changed to another
/// kind.
bool isEveryRow(const Assignment& assignment, const Parameter& row, const Scene& scene,
                const std::set<std::string_view>& changedKinds) {
  Scene measured;
  measured.surface.kind = SurfaceKind::Measured;
  const bool isZero = assignment.value == ParameterValue(std::int64_t{0});
  return isZero && assignment.fromFile && !changedKinds.empty() &&
         isTakenFromSurfaceFile(row, measured, 0) && !isTakenFromSurfaceFile(row, scene, 0) &&
         row.key.starts_with("ensemble.");
}

/// Drops the required keys of the file's own kind where --set chooses another kind: they do not
/// apply to the new one, such as the ends of a sweep.
void dropRequired(std::vector<Assignment>& assignments) {
  std::set<std::string_view> otherKinds;
  for (const Assignment& assignment : assignments) {
    if (assignment.fromFile || !isKind(assignment)) continue;
    const auto inFile = std::ranges::find_if(assignments, [&](const Assignment& other) {
      return other.fromFile && other.key == assignment.key;
    });
    if (inFile == assignments.end() || inFile->value != assignment.value)
      otherKinds.insert(knownParameter(assignment.key).key);
  }
  std::erase_if(assignments, [&](const Assignment& assignment) {
    const Parameter& row = knownParameter(assignment.key);
    return assignment.fromFile && row.rule.isRequired && dependsOn(otherKinds, row);
  });
}

void checkRequired(const std::vector<Assignment>& assignments, const Scene& scene) {
  for (const Parameter& row : parameters())
    if (row.rule.isRequired && isApplicable(row, scene) && !lastValue(assignments, row.key))
      throw InputError("", std::string(row.key),
                       message("is missing; {} {} needs it", row.applies.choiceKey,
                               std::get<std::string>(
                                   parameterValue(*findParameter(row.applies.choiceKey), scene))));
}

/// Kinds come first, because they decide which other keys have a meaning.
Scene build(std::vector<Assignment> assignments, const std::filesystem::path& folder) {
  Scene scene;
  std::set<std::string_view> changedKinds;  // by --set, away from what the file says
  dropRequired(assignments);
  chooseMaterial(assignments, scene, changedKinds);
  for (const Assignment& assignment : assignments) {
    if (!isKind(assignment)) continue;
    if (!assignment.fromFile) changedKinds.insert(knownParameter(assignment.key).key);
    apply(assignment, scene);
  }
  addMaterialValues(assignments, scene, folder);
  // Left to the surface's file unless the scene says otherwise.
  if (hasSurfaceFile(scene.surface)) {
    scene.surface.length = 0;
    scene.surface.elements = 0;
  }
  if (scene.surface.kind == SurfaceKind::Measured && !hasRandomPhases(scene.surface))
    scene.ensemble.realizations = 0;
  if (scene.accuracy.scheme == Scheme::Nodal) scene.accuracy.oversampling = 1;
  for (const Assignment& assignment : assignments) {
    const Parameter& row = knownParameter(assignment.key);
    const bool applies = isApplicable(row, scene);
    if (applies && !isKind(assignment) && !isEveryRow(assignment, row, scene, changedKinds))
      apply(assignment, scene);
    if (applies || isHarmless(assignment)) continue;
    if (!assignment.fromFile || !dependsOn(changedKinds, row)) refuseOtherKind(row, scene);
    // A choice of the file's kind was taken before it was known that it has no meaning any more.
    if (isKind(assignment)) setValue(row, scene, defaultValue(row));
  }
  checkRequired(assignments, scene);
  return scene;
}

/// Checks the sweep, and the states at its two ends.
void checkSweepAndEnds(const Scene& scene) {
  checkSweep(scene);
  if (scene.sweep.isOfVelocity()) return;
  for (const auto& [key, value] :
       {std::pair{"sweep.from", scene.sweep.from}, {"sweep.to", scene.sweep.to}})
    try {
      checkScene(sceneAt(scene, value));
    } catch (const InputError& error) {
      throw InputError("", key, message("{}: {}", error.key(), error.message()));
    }
}

Json valueJson(const Parameter& row, const ParameterValue& value) {
  if (isList(row)) return jsonValue(std::get<std::string>(value));
  return std::visit([](const auto& held) { return Json(held); }, value);
}

bool isLeftOut(const Parameter& row, const Scene& scene) {
  const bool isGivenByMaterial = row.rule.isOfMaterial && !scene.elastomer.material.empty();
  return row.rule.isLeftOutAtDefault && !isGivenByMaterial &&
         parameterValue(row, scene) == defaultValue(row);
}

/// Returns the member of a dotted key.
Json& memberAt(Json& root, std::string_view key) {
  Json* value = &root;
  for (std::size_t dot; (dot = key.find('.')) != std::string_view::npos; key.remove_prefix(dot + 1))
    value = &(*value)[std::string(key.substr(0, dot))];
  return (*value)[std::string(key)];
}

}  // namespace

Scene readScene(std::string_view json, const std::string& name, const std::filesystem::path& folder,
                const std::vector<std::string>& assignments) {
  try {
    std::vector<Assignment> all = flatten(parseJson(json, kDeepestScene, kSceneIsNeeded));
    for (const std::string& text : assignments) all.push_back(parseAssignment(text));
    chooseAccuracy(all);
    Scene scene = build(std::move(all), folder);
    checkScene(scene);
    checkSweepAndEnds(scene);
    scene.folder = folder;
    return scene;
  } catch (const InputError& error) {
    throw error.withFile(name);
  }
}

Scene readSceneFile(const std::filesystem::path& file,
                    const std::vector<std::string>& assignments) {
  return readScene(readRegularFile(file, kLargestScene), file.string(), file.parent_path(),
                   assignments);
}

bool isSetByTarget(const Parameter& row) {
  return row.key == "accuracy.scheme" || row.key == "accuracy.oversampling";
}

bool isStated(const Parameter& row, const Scene& scene) {
  if (!isApplicable(row, scene)) return false;
  if (row.key == kTarget) return choosesAccuracy(scene);
  return !isSetByTarget(row) || !choosesAccuracy(scene);
}

std::string writeScene(const Scene& scene) {
  Json root;
  root["schema"] = kSchema;
  for (const Parameter& row : parameters()) {
    if (!isStated(row, scene) || isLeftOut(row, scene)) continue;
    const ParameterValue value = parameterValue(row, scene);
    const bool hasFile = hasSurfaceFile(scene.surface);
    if (hasFile && row.key == "surface.length" && scene.surface.length == 0) continue;
    if (hasFile && row.key == "surface.elements" && scene.surface.elements == 0) continue;
    memberAt(root, row.key) = valueJson(row, value);
  }
  return jsonFile(root);
}

Scene changedScene(const Scene& scene, const std::vector<std::string>& assignments,
                   const std::string& name) {
  return readScene(writeScene(scene), name, scene.folder, assignments);
}

}  // namespace asperity
