// The materials that come with the program (resources/materials), and files of the same kind: JSON
// with the schema asperity-material/1, made by `asperity material`. core/scene/scene_file.h reads
// their values into a scene. Pure but for what reads one file; any thread.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace asperity {

inline constexpr std::string_view kMaterialSchema = "asperity-material/1";

struct ShippedMaterial {
  std::string_view name;  // "epdm_70"
  std::string_view json;
};

/// In the order of their names.
std::span<const ShippedMaterial> shippedMaterials();

struct MaterialText {
  std::string name;  // of the file, or of the shipped material, for errors
  std::string json;
};

/// The shipped material of this name or, where there is none, the file (relative to the folder).
/// Throws InputError (elastomer.material) where there is neither, or the file is larger than 1 MiB.
MaterialText readMaterialText(const std::string& name, const std::filesystem::path& folder);

/// The file of a material; empty for a shipped one.
std::filesystem::path materialFile(const std::string& name, const std::filesystem::path& folder);

}  // namespace asperity
