// The origin of a result, in every machine-readable answer and inside every file: schema, command,
// version, the canonical scene and its seed; never a date, the threads or a file's name. And the
// way back: the scene from a file that the program wrote. Pure except for reading one file; any
// thread. A scene inside a picture, film or table may come from another user (scene_demands.h).
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "core/scene/scene_files.h"

namespace asperity {

/// Returns {"schema": "asperity-VERB/1", "verb", "version", "seed" (null where nothing is random),
/// "oversampling_used", "inputs" (a list of {"key", "name", "sha256"}, where the scene names
/// files), "scene"}. The number used is that of a friction curve for the verbs that
/// compute one, else that of a single line; null where a curve to a target accuracy chooses at each
/// velocity, and for a motion whose line has its size from a file (lineProvenance adds it,
/// core/surface/line_source.h).
nlohmann::ordered_json provenance(const std::string& verb, const Scene& scene);

/// The options of a run that shape its outputs, as words of the command line without their dashes:
/// while an object lives, every provenance that is made has them as "options", from which the same
/// file can be made again. They apply to what the same thread makes; of several objects the
/// innermost counts.
class ProvenanceOptions {
 public:
  explicit ProvenanceOptions(nlohmann::ordered_json options);
  ~ProvenanceOptions();
  ProvenanceOptions(const ProvenanceOptions&) = delete;
  ProvenanceOptions& operator=(const ProvenanceOptions&) = delete;

 private:
  nlohmann::ordered_json before_;
};

/// Adds the options of the living object, if there is one, to a provenance of another kind.
void addOptions(nlohmann::ordered_json& provenance);

/// Adds "curve_oversampling_used", if it is another number, to the provenance of a result with a
/// curve and a single line, as a batch may have.
void addCurveOversampling(nlohmann::ordered_json& provenance, const Scene& scene);

/// Returns a provenance for pictures and films: one line of ASCII in which XML must escape only
/// quotes.
std::string provenanceLine(const nlohmann::ordered_json& provenance);

/// Returns the first line of a table in a file: "# asperity: {...}" with a line break.
std::string provenanceComment(const nlohmann::ordered_json& provenance);
std::string provenanceComment(const std::string& verb, const Scene& scene);

/// A scene that was read from a file.
struct FoundScene {
  Scene scene;
  /// Whether the file is a result (picture, film, table, answer) that contains the scene, which may
  /// come from another user; otherwise the file is a scene file.
  bool isEmbedded = false;
  // How a result was made, so that it can be made again; empty and null where it does not say so.
  std::string verb{};
  nlohmann::ordered_json options{};
  nlohmann::ordered_json origin{};  // all that the result says, up to its scene
  std::vector<FoundScene> parts{};  // of a result of many scenes, in its order
};

/// Returns the files that a result was made from and that are still needed to make it again.
std::vector<InputFile> inputsOf(const FoundScene& found);

/// Returns the scene in a regular file written by the program (picture, film, table, JSON answer),
/// or in a scene file. Relative file names in the scene refer to the file's folder, or to the first
/// folder above it, or the present one, in which all of them are what the result was made from. At
/// most the first and the last 8 MiB are read, and the time grows linearly with them. Throws
/// InputError where the file cannot be read or contains no scene, and where a file that the scene
/// names has another content than the one that the result was made from.
FoundScene findScene(const std::filesystem::path& file);

/// Returns the same for a result that is to be made again. It may also have many scenes (`parts`),
/// or none, as a material. from: the folder of the files that it was made from; empty: as above.
FoundScene findResult(const std::filesystem::path& file, const std::filesystem::path& from = {});

/// Returns the folders in which the inputs of a result are searched, in this order.
std::vector<std::filesystem::path> foldersAround(const std::filesystem::path& file);

/// Finds the scene in the bytes of a file; `name` is named in errors.
FoundScene findScene(std::string_view bytes, const std::string& name,
                     const std::filesystem::path& folder = {});

}  // namespace asperity
