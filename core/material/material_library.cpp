#include "core/material/material_library.h"

#include "core/base/input_error.h"
#include "core/base/regular_file.h"

namespace asperity {
namespace {

constexpr std::size_t kLargestMaterial = std::size_t{1} << 20;  // bytes

}  // namespace

std::filesystem::path materialFile(const std::string& name, const std::filesystem::path& folder) {
  return findShipped(shippedMaterials(), name) ? std::filesystem::path() : folder / name;
}

MaterialText readMaterialText(const std::string& name, const std::filesystem::path& folder) {
  if (const ShippedFile* shipped = findShipped(shippedMaterials(), name))
    return {name, std::string(shipped->json)};
  const std::filesystem::path file = folder / name;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw InputError("", kMaterialKey,
                     message("there is no file of this name, and {}",
                             notOneOf(name, namesOf(shippedMaterials()))));
  return {file.string(), readRegularFile(file, kLargestMaterial)};
}

}  // namespace asperity
