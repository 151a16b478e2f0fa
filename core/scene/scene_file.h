// Scene files (JSON): reading a scene, with assignments (KEY=VALUE) over it, and writing it. Reads
// and writes through the table of parameters; holds no state. Bad input throws InputError naming
// file, key and what is allowed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

struct Parameter;

inline constexpr std::size_t kLargestScene = std::size_t{1} << 20;  // bytes of a scene file

/// Reads a scene file and applies `assignments` ("load.normal_force=0.1") over it.
/// An assignment that changes a kind drops the file's keys that have no meaning for the new kind.
Scene readSceneFile(const std::filesystem::path& file,
                    const std::vector<std::string>& assignments = {});

/// Reads a scene from text; name: of the file, in errors; folder: the files
/// that the scene names are relative to it.
Scene readScene(std::string_view json, const std::string& name,
                const std::filesystem::path& folder = {},
                const std::vector<std::string>& assignments = {});

/// Stands for the folder of the shipped scenes: a scene that is named in it is the shipped one,
/// even if the current folder has a file of that name.
inline constexpr const char* kShippedFolder = ":";

/// Reads a scene that a study or a lesson names: a file relative to the folder, or a shipped scene
/// where the caller has these.
using SceneReader =
    std::function<Scene(const std::string& name, const std::filesystem::path& folder,
                        const std::vector<std::string>& assignments)>;

/// Returns the canonical text: every applicable key in the table's order, numbers in the shortest
/// form that reads back to the same value. readScene(writeScene(s)) == s up to the folder.
std::string writeScene(const Scene& scene);

/// Returns whether a target accuracy determines the value of the row: only one of both is stated.
bool isSetByTarget(const Parameter& row);
/// Returns whether the canonical text states the row.
bool isStated(const Parameter& row, const Scene& scene);

/// Returns the scene with these keys changed, and checked as if it were read. name: in errors.
Scene changedScene(const Scene& scene, const std::vector<std::string>& assignments,
                   const std::string& name);

}  // namespace asperity
