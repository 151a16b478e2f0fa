// The shipped materials (resources/materials), and files of the same kind: JSON with the schema
// asperity-material/1, made by `asperity material`. core/scene/scene_file.h reads their values into
// a scene. Pure except for reading one file; any thread.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/shipped_file.h"

namespace asperity {

inline constexpr const char* kMaterialKey = "elastomer.material";  // names one in a scene
inline constexpr std::string_view kMaterialSchema = "asperity-material/1";

/// Returns the shipped materials in the order of their names.
std::span<const ShippedFile> shippedMaterials();

struct MaterialText {
  std::string name;  // of the file, or of the shipped material, for errors
  std::string json;
};

/// Returns the shipped material of this name or, where there is none, the file (relative to the
/// folder). Throws InputError (elastomer.material) where there is neither, or the file is larger
/// than 1 MiB.
MaterialText readMaterialText(const std::string& name, const std::filesystem::path& folder);

/// Returns the path of a material's file; empty for a shipped one.
std::filesystem::path materialFile(const std::string& name, const std::filesystem::path& folder);

}  // namespace asperity
