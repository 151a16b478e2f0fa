// Files that a scene names: which they are, how they are named, and what naming one means for the
// scene. Pure but for reading the file of a material and following links; any thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace asperity {

/// A file that a scene names, or that a result was made from: "comparison.data", "data.csv", its
/// SHA-256 (empty: unknown).
struct InputFile {
  std::string key, name, sha256;
};

/// Returns the files and shipped materials that a scene names, without their digests.
std::vector<InputFile> namedFiles(const Scene& scene);

/// Returns the path of every file that a scene names, whether it is used or not: a result must not
/// replace one of them.
std::vector<std::filesystem::path> filesReadBy(const Scene& scene);

/// Returns the file's name in the scene: relative where the file lies in the scene's folder or
/// below.
std::string nameInScene(const Scene& scene, const std::filesystem::path& file);

/// Returns the scene with absolute names of its files, which are found from any folder.
Scene withAbsoluteFiles(const Scene& scene);

/// Returns the scene with its files named relative to a folder, into which it is to be written.
/// Absolute names stay where the file lies outside of the folder; a scene beside its files can be
/// moved together with them.
Scene withFilesRelativeTo(const std::filesystem::path& folder, const Scene& scene);

/// Makes a shipped material, or one of a file, that of the scene: its elastomer then has all values
/// of the material, at the scene's temperature. An empty name forgets the name and keeps the
/// values. Throws InputError where there is no such material.
void useMaterial(Scene& scene, const std::string& name);

/// Makes a measured file the surface of the scene, read with the metadata of the file, which also
/// gives the period, the elements and the lines. Choices that were made for the same file stay.
void useSurface(Scene& scene, const std::filesystem::path& file);

}  // namespace asperity
