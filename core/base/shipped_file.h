// Files of resources/ that stand in the libraries themselves, because core has no other place for
// resources: asperity_ship in core/CMakeLists.txt writes them into sources.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

namespace asperity {

struct ShippedFile {
  std::string_view name;  // without ".json"
  std::string_view json;
};

/// Returns the file of this name; null where there is none.
inline const ShippedFile* findShipped(std::span<const ShippedFile> files, std::string_view name) {
  const auto found = std::ranges::find(files, name, &ShippedFile::name);
  return found == files.end() ? nullptr : &*found;
}

inline std::vector<std::string_view> namesOf(std::span<const ShippedFile> files) {
  std::vector<std::string_view> names;
  for (const ShippedFile& file : files) names.push_back(file.name);
  return names;
}

}  // namespace asperity
