#include "core/scene/provenance.h"

#include <algorithm>
#include <functional>
#include <set>
#include <system_error>

#include "core/base/carried_text.h"
#include "core/base/file_digest.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/regular_file.h"
#include "core/base/text.h"
#include "core/material/material_library.h"
#include "core/scene/scene_file.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

/// The number of bytes that are read at each end of a file: every kind of file has its text at one
/// of them.
constexpr std::size_t kEnd = std::size_t{8} << 20;
constexpr int kDeepest = 16;  // largest nesting, as for a scene in an answer

/// Returns the first and the last bytes of a file, with nothing in between.
std::string endsOf(const RegularFile& file) {
  if (file.size() <= 2 * kEnd) return file.read(0, 2 * kEnd);
  return file.read(0, kEnd) + file.read(file.size() - kEnd, kEnd);
}

/// Returns ASCII without characters that XML must escape, except for quotes; it reads each byte
/// once.
std::string withoutMarkup(std::string_view json) {
  std::string line;
  line.reserve(json.size());
  for (const char letter : json) switch (letter) {
      case '&':
        line += "\\u0026";
        break;
      case '<':
        line += "\\u003c";
        break;
      case '>':
        line += "\\u003e";
        break;
      default:
        line += letter;
    }
  return line;
}

/// Returns null where a curve with a target accuracy has another number at each velocity.
Json oversamplingOf(std::string_view verb, const Scene& scene) {
  if (verb == "curve" && choosesAccuracy(scene)) return {};
  const bool isOfCurve = verb == "curve" || verb == "map" || verb == "sensitivity" ||
                         verb == "cutoff" || verb == "figure" || verb == "accuracy";
  return isOfCurve ? pointsPerElementOfCurve(scene) : pointsPerElement(scene);
}

/// Calls `add` with key, name and SHA-256 for each file that the scene names. A file that cannot be
/// read has no digest: the command that needs it reports the error.
template <class Add>
void eachInput(const Scene& scene, const Add& add) {
  const auto digested = [&](const char* key, const std::string& name, const auto& digest) {
    if (name.empty()) return;
    Json found;
    try {
      found = digest();
    } catch (const InputError&) {
    }
    add(key, name, std::move(found));
  };
  if (hasSurfaceFile(scene.surface))
    digested("surface.file", scene.surface.file,
             [&] { return sha256OfFile(scene.folder / scene.surface.file); });
  const std::string& material = scene.elastomer.material;
  if (scene.elastomer.rheology == Rheology::Prony)
    digested("elastomer.material", material,
             [&] { return sha256(readMaterialText(material, scene.folder).json); });
  for (const DataFile& table : scene.comparison.data)
    digested("comparison.data", table.file,
             [&] { return sha256OfFile(scene.folder / table.file); });
}

/// The files that a scene names, each with the SHA-256 of its content.
Json inputsOf(const Scene& scene) {
  Json inputs = Json::array();
  eachInput(scene, [&](const char* key, const std::string& name, Json digest) {
    inputs.push_back({{"key", key}, {"name", name}, {"sha256", std::move(digest)}});
  });
  return inputs;
}

/// Refuses a scene whose file has another content than the one that the result was made from. A
/// missing file is reported by the command that needs it. A shipped material may have changed: the
/// scene holds its values.
void checkInputs(const Json& inputs, const Scene& scene) {
  if (!inputs.is_array()) return;
  eachInput(scene, [&](std::string_view key, const std::string& name, const Json& present) {
    const bool isShipped = key == "elastomer.material" && materialFile(name, scene.folder).empty();
    if (isShipped || !present.is_string()) return;
    for (const Json& input : inputs) {
      if (!input.is_object() || input.value("key", Json()) != Json(key) ||
          input.value("name", Json()) != Json(name))
        continue;
      const Json made = input.value("sha256", Json());
      if (made.is_string() && made != present)
        throw InputError("", std::string(key),
                         message("{}: it is another file now: its SHA-256 is {}, and the result "
                                 "was made from {}",
                                 name, shortened(present.get<std::string>()),
                                 shortened(made.get<std::string>())));
    }
  });
}

/// Null where no object of ProvenanceOptions lives.
Json& presentOptions() {
  static Json options;
  return options;
}

}  // namespace

ProvenanceOptions::ProvenanceOptions(Json options) {
  presentOptions() = std::move(options);
}

ProvenanceOptions::~ProvenanceOptions() {
  presentOptions() = nullptr;
}

void addCurveOversampling(Json& provenance, const Scene& scene) {
  const std::int64_t ofCurve = pointsPerElementOfCurve(scene);
  if (provenance["oversampling_used"] != ofCurve) provenance["curve_oversampling_used"] = ofCurve;
}

Json provenance(const std::string& verb, const Scene& scene) {
  Json root;
  root["schema"] = "asperity-" + verb + "/1";
  root["verb"] = verb;
  root["version"] = ASPERITY_VERSION;
  root["seed"] = hasRandomPhases(scene.surface) ? Json(scene.surface.seed) : Json();
  root["oversampling_used"] = oversamplingOf(verb, scene);
  if (verb == "batch") addCurveOversampling(root, scene);
  if (Json inputs = inputsOf(scene); !inputs.empty()) root["inputs"] = std::move(inputs);
  if (!presentOptions().is_null()) root["options"] = presentOptions();
  root["scene"] = Json::parse(writeScene(scene));
  return root;
}

std::string provenanceLine(const Json& provenance) {
  return withoutMarkup(provenance.dump(-1, ' ', true));
}

std::string provenanceComment(const std::string& verb, const Scene& scene) {
  return "# asperity: " + provenanceLine(provenance(verb, scene)) + "\n";
}

FoundScene findScene(std::string_view bytes, const std::string& name,
                     const std::filesystem::path& folder) {
  const bool isText = beginsAsObject(bytes);
  const std::string carried = isText ? std::string() : carriedText(bytes);
  const std::string_view json = isText ? bytes : carried;
  try {
    std::set<std::string> others;
    const Json scene = beginsAsObject(json) ? memberOf(json, "scene", kDeepest, &others) : Json();
    if (scene.is_object()) {
      FoundScene found{readScene(scene.dump(), name, folder), true};
      if (others.contains("verb"))
        if (const Json verb = memberOf(json, "verb", kDeepest); verb.is_string())
          found.verb = verb.get<std::string>();
      if (others.contains("options")) found.options = memberOf(json, "options", kDeepest);
      if (others.contains("inputs")) checkInputs(memberOf(json, "inputs", kDeepest), found.scene);
      return found;
    }
    if (others.contains("scenes"))
      throw InputError("", "", "shows many scenes; open the picture or the table of one of them");
  } catch (const InputError& error) {
    throw error.file().empty() ? error.in(name) : error;
  }
  if (!isText)
    throw InputError(name, "",
                     "holds no scene: it was not made by Asperity, or what it said of itself was "
                     "removed");
  if (bytes.size() > kLargestScene) throw InputError(name, "", "is larger than a scene may be");
  return {readScene(bytes, name, folder), false};
}

FoundScene findScene(const std::filesystem::path& file) {
  return findScene(endsOf(RegularFile(file)), file.string(), file.parent_path());
}

Scene readProvenance(const std::filesystem::path& file) {
  return findScene(file).scene;
}

namespace {

namespace fs = std::filesystem;

// These were measured in the window, with a rough line under force; accurate to a factor of about
// two.
constexpr double kBytesPerNode = 150;     // line, its blocks, the march and its frames
constexpr double kSecondsPerNode = 1e-9;  // for one pass over a line; a velocity takes six
constexpr double kPasses = 6, kPassesOfLine = 40;
constexpr double kBytesPerRow = 8;  // minimum for a row of a profile's file

/// Returns whether the file is in or below the folder; links are followed. A name with a zero byte
/// would mean another file to the system.
bool liesBelow(const fs::path& file, const fs::path& folder) {
  if (file.native().find('\0') != std::string::npos) return false;
  std::error_code noFile, noFolder;
  const fs::path home = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, noFolder);
  const fs::path place = fs::weakly_canonical(file, noFile).lexically_relative(home);
  return !noFile && !noFolder && !place.empty() && *place.begin() != "..";
}

double nodesOf(const Scene& scene, const fs::path& file) {
  double elements = static_cast<double>(scene.surface.elements);
  if (elements == 0) {  // the number comes from the profile
    std::error_code error;
    const std::uintmax_t size = fs::file_size(file, error);
    if (!error) elements = static_cast<double>(size) / kBytesPerRow;
  }
  return elements * static_cast<double>(std::max<std::int64_t>(pointsPerElement(scene), 1));
}

}  // namespace

SceneDemands demandsOf(const Scene& scene) {
  SceneDemands demands;
  const fs::path file =
      hasSurfaceFile(scene.surface) ? scene.folder / scene.surface.file : fs::path();
  if (!file.empty() && !liesBelow(file, scene.folder)) demands.file = file;
  const std::string& material = scene.elastomer.material;
  const fs::path materials = material.empty() ? fs::path() : materialFile(material, scene.folder);
  if (demands.file.empty() && !materials.empty() && !liesBelow(materials, scene.folder))
    demands.file = materials;
  const double nodes = nodesOf(scene, file);
  const double lines =
      mayHaveManyLines(scene.surface)
          ? static_cast<double>(std::max<std::int64_t>(scene.ensemble.realizations, 1))
          : 1;
  const double passes = kPassesOfLine + kPasses * static_cast<double>(scene.sweep.points);
  const double memory = nodes * kBytesPerNode, seconds = nodes * lines * passes * kSecondsPerNode;
  if (memory > kMemoryUnasked) demands.memory = memory;
  if (seconds > kSecondsUnasked) demands.seconds = seconds;
  return demands;
}

}  // namespace asperity
