#include "core/scene/provenance.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/base/embedded_provenance.h"
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

/// Returns null where a curve with a target accuracy has another number at each velocity, and where
/// only the surface's file has the size of the line that decides.
Json levelOversampling(std::string_view verb, const Scene& scene) {
  if (verb == "curve" && choosesAccuracy(scene)) return {};
  const bool isOfCurve = verb == "curve" || verb == "map" || verb == "sensitivity" ||
                         verb == "cutoff" || verb == "figure" || verb == "accuracy";
  if (isOfCurve) return curvePointsPerElement(scene);
  return needsSizeOfFile(scene) ? Json() : Json(pointsPerElement(scene));
}

constexpr const char* kMeasurements = "FILE";  // key of the file that a material is made from

bool isMaterial(const InputFile& file) {
  return file.key == kMaterialKey;
}

/// Returns the files that a scene names and uses, without their digests.
std::vector<InputFile> filesOf(const Scene& scene) {
  std::vector<InputFile> files = namedFiles(scene);
  std::erase_if(files, [&](const InputFile& file) {
    return (file.key == "surface.file" && !hasSurfaceFile(scene.surface)) ||
           (isMaterial(file) && scene.elastomer.rheology != Rheology::Prony);
  });
  return files;
}

/// A file that cannot be read has no digest: the command that needs it reports the error.
std::string digestOf(const InputFile& file, const std::filesystem::path& folder) {
  try {
    return isMaterial(file) ? sha256(readMaterialText(file.name, folder).json)
                            : sha256OfFile(folder / file.name);
  } catch (const InputError&) {
    return {};
  }
}

/// Returns the files that a scene names, each with the SHA-256 of its content.
Json inputsJson(const Scene& scene) {
  Json inputs = Json::array();
  for (const InputFile& file : filesOf(scene)) {
    const std::string digest = digestOf(file, scene.folder);
    inputs.push_back({{"key", file.key},
                      {"name", file.name},
                      {"sha256", digest.empty() ? Json() : Json(digest)}});
  }
  return inputs;
}

std::string textIn(const Json& object, const char* member) {
  if (!object.is_object() || !object.contains(member) || !object[member].is_string()) return {};
  return object[member].get<std::string>();
}

/// Sets the digest of each file that the result states for it.
void addDigests(const Json& inputs, std::vector<InputFile>& files) {
  if (!inputs.is_array()) return;
  for (InputFile& file : files)
    for (const Json& input : inputs)
      if (textIn(input, "key") == file.key && textIn(input, "name") == file.name)
        file.sha256 = textIn(input, "sha256");
}

/// Returns the first folder in which all files have their recorded content; else the first one that
/// has all of them, whose difference an error can name; else the first one.
std::filesystem::path folderOf(const std::vector<InputFile>& files,
                               const std::vector<std::filesystem::path>& folders) {
  std::error_code ignored;
  for (const auto& folder : folders)
    if (std::ranges::all_of(files, [&](const InputFile& file) {
          return file.sha256.empty() ? std::filesystem::exists(folder / file.name, ignored)
                                     : digestOf(file, folder) == file.sha256;
        }))
      return folder;
  for (const auto& folder : folders)
    if (std::ranges::all_of(files, [&](const InputFile& file) {
          return std::filesystem::exists(folder / file.name, ignored);
        }))
      return folder;
  return folders.front();
}

/// Throws InputError for a file that has another content than the one from which the result was
/// made. A missing file is reported by the command that needs it.
void checkInputs(const std::vector<InputFile>& files, const std::filesystem::path& folder) {
  for (const InputFile& file : files) {
    const std::string present = file.sha256.empty() ? std::string() : digestOf(file, folder);
    if (!present.empty() && present != file.sha256)
      throw InputError("", file.key,
                       message("{}: it is another file now: its SHA-256 is {}, and the result "
                               "was made from {}",
                               file.name, shortened(present), shortened(file.sha256)));
  }
}

/// Returns the scene of a result, or of one of its parts, with the folder of its files.
FoundScene resultFrom(Json origin, const std::string& name,
                      const std::vector<std::filesystem::path>& folders) {
  FoundScene found;
  found.isEmbedded = true;
  found.verb = textIn(origin, "verb");
  if (const auto scene = origin.find("scene"); scene != origin.end() && scene->is_object())
    found.scene = readScene(scene->dump(), name, folders.front());
  if (origin.contains("options")) found.options = origin["options"];
  found.origin = std::move(origin);
  const std::vector<InputFile> files = inputsOf(found);
  found.scene.folder = folderOf(files, folders);
  checkInputs(files, found.scene.folder);
  return found;
}

/// Returns the options of the innermost ProvenanceOptions of this thread; null where none lives.
Json& presentOptions() {
  thread_local Json options;
  return options;
}

}  // namespace

ProvenanceOptions::ProvenanceOptions(Json options)
    : before_(std::exchange(presentOptions(), std::move(options))) {}

ProvenanceOptions::~ProvenanceOptions() {
  presentOptions() = std::move(before_);
}

void addOptions(Json& provenance) {
  if (!presentOptions().is_null()) provenance["options"] = presentOptions();
}

void addCurveOversampling(Json& provenance, const Scene& scene) {
  const std::int64_t ofCurve = curvePointsPerElement(scene);
  if (provenance["oversampling_used"] != ofCurve) provenance["curve_oversampling_used"] = ofCurve;
}

Json provenance(const std::string& verb, const Scene& scene) {
  Json root;
  root["schema"] = "asperity-" + verb + "/1";
  root["verb"] = verb;
  root["version"] = ASPERITY_VERSION;
  root["seed"] = hasRandomPhases(scene.surface) ? Json(scene.surface.seed) : Json();
  root["oversampling_used"] = levelOversampling(verb, scene);
  if (verb == "batch") addCurveOversampling(root, scene);
  if (Json inputs = inputsJson(scene); !inputs.empty()) root["inputs"] = std::move(inputs);
  addOptions(root);
  root["scene"] = jsonValue(writeScene(scene));
  return root;
}

std::string provenanceLine(const Json& provenance) {
  // Names of files and texts of options may be in another encoding.
  return withoutMarkup(provenance.dump(-1, ' ', true, Json::error_handler_t::replace));
}

std::string provenanceComment(const Json& provenance) {
  return "# asperity: " + provenanceLine(provenance) + "\n";
}

std::string provenanceComment(const std::string& verb, const Scene& scene) {
  return provenanceComment(provenance(verb, scene));
}

std::vector<InputFile> inputsOf(const FoundScene& found) {
  std::vector<InputFile> files = filesOf(found.scene);
  // A shipped material may have changed: the scene holds its values.
  std::erase_if(files, [&](const InputFile& file) {
    return isMaterial(file) && materialFile(file.name, found.scene.folder).empty();
  });
  const Json& origin = found.origin;
  if (!origin.is_object()) return files;
  if (origin.contains("inputs")) addDigests(origin["inputs"], files);
  if (const auto made = origin.find("origin"); made != origin.end()) {
    const std::string name = std::filesystem::path(textIn(*made, "file")).filename().string();
    if (!name.empty()) files.push_back({kMeasurements, name, textIn(*made, "sha256")});
  }
  return files;
}

std::vector<std::filesystem::path> foldersAround(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> folders{file.parent_path()};
  while (folders.back().has_relative_path()) folders.push_back(folders.back().parent_path());
  if (!folders.back().empty()) folders.emplace_back();  // the present one
  return folders;
}

namespace {

/// Finds the scene in the bytes of a file. toRemake: whether a result without a scene of its own,
/// or with many, is an answer, too.
FoundScene sceneIn(std::string_view bytes, const std::string& name,
                   const std::vector<std::filesystem::path>& folders, bool toRemake) {
  const bool isText = beginsAsObject(bytes);
  const std::string carried = isText ? std::string() : embeddedProvenance(bytes);
  const std::string_view json = isText ? bytes : carried;
  try {
    Json origin = beginsAsObject(json) ? membersUpTo(json, "scene", kDeepest) : Json();
    if (!origin.is_object()) origin = Json::object();
    const bool hasScene = origin.contains("scene") && origin["scene"].is_object();
    const bool hasMany = origin.contains("scenes") && origin["scenes"].is_array();
    if (hasScene) return resultFrom(std::move(origin), name, folders);
    if (origin.contains("scenes") && !(toRemake && hasMany))
      throw InputError("", "", "shows many scenes; open the picture or the table of one of them");
    if (toRemake && (hasMany || (origin.contains("origin") && origin["origin"].is_object()))) {
      FoundScene result = resultFrom(std::move(origin), name, folders);
      if (hasMany)
        for (const Json& part : result.origin["scenes"])
          result.parts.push_back(
              resultFrom(part.is_object() ? part : Json::object(), name, folders));
      return result;
    }
    if (!isText && origin.contains("origin") && origin["origin"].contains("file"))
      throw InputError("", "", "holds no scene: it was made from a table of moduli");
  } catch (const InputError& error) {
    throw error.withFile(name);
  }
  if (!isText)
    throw InputError(name, "",
                     "holds no scene: Asperity did not write this file, or the scene in it was "
                     "removed");
  if (bytes.size() > kLargestScene) throw InputError(name, "", "is larger than a scene may be");
  FoundScene plain;
  plain.scene = readScene(bytes, name, folders.front());
  return plain;
}

}  // namespace

FoundScene findScene(std::string_view bytes, const std::string& name,
                     const std::filesystem::path& folder) {
  return sceneIn(bytes, name, {folder}, false);
}

FoundScene findScene(const std::filesystem::path& file) {
  return sceneIn(endsOf(RegularFile(file)), file.string(), foldersAround(file), false);
}

FoundScene findResult(const std::filesystem::path& file, const std::filesystem::path& from) {
  std::vector<std::filesystem::path> folders = foldersAround(file);
  if (!from.empty()) folders = {from};
  return sceneIn(endsOf(RegularFile(file)), file.string(), folders, true);
}

}  // namespace asperity
