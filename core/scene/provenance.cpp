#include "core/scene/provenance.h"

#include "core/scene/atomic_file.h"
#include "core/scene/input_error.h"
#include "core/scene/scene_file.h"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLargestOutput = std::size_t{1} << 30;  // bytes
constexpr std::string_view kBeginning = R"({"schema":"asperity-)";
constexpr std::string_view kEscapedBeginning = "{&quot;schema&quot;:&quot;asperity-";

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// Where the object that begins the text ends: braces within strings do not count.
std::size_t endOfObject(std::string_view text, std::string_view quote) {
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && inString) {
      ++i;
      if (text.substr(i).starts_with(quote)) i += quote.size() - 1;
    } else if (text.substr(i).starts_with(quote)) {
      inString = !inString;
      i += quote.size() - 1;
    } else if (!inString && text[i] == '{') {
      ++depth;
    } else if (!inString && text[i] == '}' && --depth == 0) {
      return i + 1;
    }
  }
  return std::string_view::npos;
}

std::string_view findFrom(std::string_view bytes, std::string_view beginning,
                          std::string_view quote) {
  const std::size_t at = bytes.find(beginning);
  if (at == std::string_view::npos) return {};
  const std::size_t end = endOfObject(bytes.substr(at), quote);
  return end == std::string_view::npos ? std::string_view{} : bytes.substr(at, end);
}

/// The scene of an answer or of a provenance; anything else as it is.
std::string sceneOf(const std::string& json, const std::string& file) {
  const Json root = Json::parse(json, nullptr, false);
  if (!root.is_object()) return json;
  if (root.value("verb", Json()) == "batch" && root.contains("scenes"))
    throw InputError(file, "", "shows many scenes; open the picture or the table of one of them");
  const auto scene = root.find("scene");
  return scene != root.end() && scene->is_object() ? scene->dump() : json;
}

/// Null where a curve to a target accuracy has another number at each velocity.
Json oversamplingOf(std::string_view verb, const Scene& scene) {
  if (verb == "curve" && choosesAccuracy(scene)) return {};
  const bool isOfCurve = verb == "curve" || verb == "figure" || verb == "accuracy";
  return isOfCurve ? pointsPerElementOfCurve(scene) : pointsPerElement(scene);
}

}  // namespace

void addCurveOversampling(Json& provenance, const Scene& scene) {
  const std::int64_t ofCurve = pointsPerElementOfCurve(scene);
  if (provenance["oversampling_used"] != ofCurve) provenance["curve_oversampling_used"] = ofCurve;
}

Json provenance(const std::string& verb, const Scene& scene) {
  Json root;
  root["schema"] = "asperity-" + verb + "/1";
  root["verb"] = verb;
  root["version"] = ASPERITY_VERSION;
  root["seed"] = scene.surface.kind == SurfaceKind::SelfAffine ? Json(scene.surface.seed) : Json();
  root["oversampling_used"] = oversamplingOf(verb, scene);
  if (verb == "batch") addCurveOversampling(root, scene);
  root["scene"] = Json::parse(writeScene(scene));
  return root;
}

std::string provenanceLine(const Json& provenance) {
  std::string line = provenance.dump(-1, ' ', true);
  line = replaced(std::move(line), "&", "\\u0026");
  line = replaced(std::move(line), "<", "\\u003c");
  return replaced(std::move(line), ">", "\\u003e");
}

std::string provenanceComment(const std::string& verb, const Scene& scene) {
  return "# asperity: " + provenanceLine(provenance(verb, scene)) + "\n";
}

std::string_view findProvenance(std::string_view bytes) {
  const std::string_view plain = findFrom(bytes, kBeginning, "\"");
  return plain.empty() ? findFrom(bytes, kEscapedBeginning, "&quot;") : plain;
}

Scene readProvenance(const std::filesystem::path& file) {
  const std::string bytes = readWholeFile(file, kLargestOutput);
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool isJson = first != std::string::npos && bytes[first] == '{';
  const std::string json =
      isJson ? bytes : replaced(std::string(findProvenance(bytes)), "&quot;", "\"");
  if (json.empty())
    throw InputError(file.string(), "",
                     "holds no scene: it was not made by Asperity, or what it said of itself was "
                     "removed");
  return readScene(sceneOf(json, file.string()), file.string(), file.parent_path());
}

}  // namespace asperity
