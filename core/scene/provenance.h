// How a result came about, in every machine-readable answer and inside every file: schema, verb,
// version, the canonical scene and its seed; never a date, the threads or a file's name. And the
// way back: the scene out of a file that the program wrote. Pure but for what reads one file; any
// thread.
// A scene that comes inside of a picture, film or table may be another person's: SceneDemands says
// what it asks for beyond being shown, so that its reader can be asked first.
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

/// For what shows a curve beside a single line, as a batch always may: "curve_oversampling_used",
/// where that is another number.
void addCurveOversampling(nlohmann::ordered_json& provenance, const Scene& scene);

/// A provenance as it stands inside pictures and films: one line of ASCII in which XML has nothing
/// to escape but quotes.
std::string provenanceLine(const nlohmann::ordered_json& provenance);

/// The first line of a table in a file: "# asperity: {...}" and its line end.
std::string provenanceComment(const std::string& verb, const Scene& scene);

/// A scene that was read from a file.
struct FoundScene {
  Scene scene;
  /// Whether it stands in what was made from it (picture, film, table, answer), and may be another
  /// person's; otherwise the file is a scene file.
  bool isCarried = false;
};

/// The scene in a regular file written by the program (picture, film, table, JSON answer), or of a
/// scene file. What the scene names relative to itself is looked for beside the file. At most the
/// first and the last 8 MiB are read, in a time that grows with them alone. Throws InputError where
/// the file does not read or holds no scene, and where a file that the scene names has another
/// content than the one that stands in the provenance.
FoundScene findScene(const std::filesystem::path& file);

/// The same in the bytes of a file; `name` stands for it in errors.
FoundScene findScene(std::string_view bytes, const std::string& name,
                     const std::filesystem::path& folder = {});

/// The scene alone.
Scene readProvenance(const std::filesystem::path& file);

/// What such a scene may take unasked.
inline constexpr double kMemoryUnasked = 1e9;   // bytes
inline constexpr double kSecondsUnasked = 600;  // of one processor

struct SceneDemands {
  std::filesystem::path file;  // a profile that lies neither beside the scene nor below; or empty
  double memory = 0;           // bytes, where it is more than kMemoryUnasked, roughly
  double seconds = 0;          // of one processor, where it is more than kSecondsUnasked, roughly

  bool any() const { return !file.empty() || memory > 0 || seconds > 0; }
};

/// scene.folder: where the file lies that carries the scene.
SceneDemands demandsOf(const Scene& scene);

}  // namespace asperity
