#include "core/material/material_library.h"

#include <algorithm>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/regular_file.h"

namespace asperity {
namespace {

constexpr std::size_t kLargestMaterial = std::size_t{1} << 20;  // bytes

const ShippedMaterial* findShipped(std::string_view name) {
  const auto materials = shippedMaterials();
  const auto found = std::ranges::find(materials, name, &ShippedMaterial::name);
  return found == materials.end() ? nullptr : &*found;
}

}  // namespace

std::filesystem::path materialFile(const std::string& name, const std::filesystem::path& folder) {
  return findShipped(name) ? std::filesystem::path() : folder / name;
}

MaterialText readMaterialText(const std::string& name, const std::filesystem::path& folder) {
  if (const ShippedMaterial* shipped = findShipped(name)) return {name, std::string(shipped->json)};
  const std::filesystem::path file = folder / name;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    std::vector<std::string_view> names;
    for (const ShippedMaterial& material : shippedMaterials()) names.push_back(material.name);
    throw InputError("", kMaterialKey,
                     message("there is no file of this name, and {}", notOneOf(name, names)));
  }
  return {file.string(), readRegularFile(file, kLargestMaterial)};
}

}  // namespace asperity
