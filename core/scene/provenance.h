// The origin of a result, in every machine-readable answer and inside every file: schema, command,
// version, the canonical scene and its seed; never a date, the threads or a file's name. And the
// way back: the scene from a file that the program wrote. Pure except for reading one file; any
// thread. A scene inside a picture, film or table may come from another user: SceneDemands lists
// what it needs beyond being shown, so that the reader can be asked first.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/scene/scene.h"

namespace asperity {

/// {"schema": "asperity-VERB/1", "verb", "version", "seed" (null where nothing is random),
/// "oversampling_used", "files" (name and SHA-256 of each file that the scene names, by its key; only
/// where it names one), "scene"}. The number used is that of a friction curve for the verbs that
/// compute one, else that of a single line; null where a curve to a target accuracy chooses at each
/// velocity.
nlohmann::ordered_json provenance(const std::string& verb, const Scene& scene);

/// Adds "curve_oversampling_used", if it is another number, to the provenance of a result with a
/// curve and a single line, as a batch may have.
void addCurveOversampling(nlohmann::ordered_json& provenance, const Scene& scene);

/// Returns a provenance for pictures and films: one line of ASCII in which XML must escape only
/// quotes.
std::string provenanceLine(const nlohmann::ordered_json& provenance);

/// Returns the first line of a table in a file: "# asperity: {...}" with a line break.
std::string provenanceComment(const std::string& verb, const Scene& scene);

/// A scene that was read from a file.
struct FoundScene {
  Scene scene;
  /// Whether the file is a result (picture, film, table, answer) that contains the scene, which may
  /// come from another user; otherwise the file is a scene file.
  bool isCarried = false;
};

/// The scene in a regular file written by the program (picture, film, table, JSON answer), or of a
/// scene file. What the scene names relative to itself is looked for beside the file. At most the
/// first and the last 8 MiB are read, in a time that grows with them alone. Throws InputError where
/// the file does not read or holds no scene, and where a file that the scene names has another
/// content than the one that stands in the provenance.
FoundScene findScene(const std::filesystem::path& file);

/// Finds the scene in the bytes of a file; `name` is named in errors.
FoundScene findScene(std::string_view bytes, const std::string& name,
                     const std::filesystem::path& folder = {});

/// Returns only the scene.
Scene readProvenance(const std::filesystem::path& file);

/// Limits of memory and time for such a scene without a question.
inline constexpr double kMemoryUnasked = 1e9;   // bytes
inline constexpr double kSecondsUnasked = 600;  // of one processor

struct SceneDemands {
  // a profile outside of the scene's folder and its subfolders; or empty
  std::filesystem::path file;
  double memory = 0;   // bytes, if more than kMemoryUnasked; approximate
  double seconds = 0;  // of one processor, if more than kSecondsUnasked; approximate

  bool any() const { return !file.empty() || memory > 0 || seconds > 0; }
};

/// Returns the demands. scene.folder: the folder of the file that contains the scene.
SceneDemands demandsOf(const Scene& scene);

}  // namespace asperity
