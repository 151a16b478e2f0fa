#include "ui/window/import/file_kind.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "core/base/embedded_provenance.h"
#include "core/base/input_error.h"
#include "core/base/json_text.h"
#include "core/base/regular_file.h"
#include "core/base/text_number.h"
#include "core/base/text_table.h"
#include "core/fit/friction_data.h"
#include "core/material/dma_columns.h"
#include "core/material/material_library.h"
#include "core/material/prony_file.h"

namespace asperity {

namespace {

constexpr std::size_t kBeginning = 64 << 10;                     // bytes
constexpr std::uint64_t kLargestTable = std::uint64_t{8} << 20;  // bytes of measured moduli

/// Pictures and films, which hold a scene or nothing that can be opened.
bool isPicture(const std::filesystem::path& file) {
  static constexpr std::array<std::string_view, 10> kExtensions{
      ".png", ".svg", ".pdf", ".eps", ".tif", ".tiff", ".mp4", ".webm", ".gif", ".webp"};
  return std::ranges::find(kExtensions, lowerCase(file.extension().string())) != kExtensions.end();
}

bool isMaterialJson(std::string_view text) {
  const auto root = nlohmann::json::parse(text, nullptr, false);
  return root.is_object() && root.contains("schema") && root["schema"] == kMaterialSchema;
}

/// Returns whether a table has columns of frequency and of a modulus, by their names.
bool hasModuli(const TextTable& table) {
  for (const TextBlock& block : table.blocks) {
    bool hasFrequency = false, hasModulus = false;
    for (const TextColumn& column : block.columns) {
      const DmaQuantity quantity = dmaColumn(column.name, column.unit).quantity;
      hasFrequency = hasFrequency || quantity == DmaQuantity::Frequency ||
                     quantity == DmaQuantity::ReducedFrequency;
      hasModulus = hasModulus || quantity == DmaQuantity::Storage ||
                   quantity == DmaQuantity::Loss || quantity == DmaQuantity::Magnitude;
    }
    if (hasFrequency && hasModulus) return true;
  }
  return false;
}

/// Returns the kind of a table of numbers; a table of no other kind is a surface.
FileKind kindOfText(const std::string& text) {
  try {
    if (readPronyFile(text, nullptr, "", {})) return FileKind::Moduli;
  } catch (const InputError&) {
    return FileKind::Moduli;  // a series with a fault, which its page explains
  }
  std::optional<TextTable> table;
  try {
    TextTableOptions options;
    options.keepsTexts = true;
    table = readTextTable(text, "", options);
  } catch (const InputError&) {
    return FileKind::Surface;
  }
  if (isFrictionTable(*table)) return FileKind::Friction;
  if (hasModuli(*table)) return FileKind::Moduli;
  try {
    return readPronyFile(text, &*table, "", {}) ? FileKind::Moduli : FileKind::Surface;
  } catch (const InputError&) {
    return FileKind::Moduli;
  }
}

}  // namespace

FileKind kindOfFile(const std::filesystem::path& file) {
  try {
    const RegularFile opened(file);
    const std::string beginning = opened.read(0, kBeginning);
    if (beginsAsObject(beginning)) {
      constexpr std::size_t kLargestMaterial = std::size_t{1} << 20;
      return isMaterialJson(opened.read(0, kLargestMaterial)) ? FileKind::Material
                                                              : FileKind::Scene;
    }
    if (isPicture(file) || beginsAsObject(embeddedProvenance(beginning))) return FileKind::Scene;
    const bool mayBeText = beginning.find('\0') == beginning.npos ||
                           beginning.starts_with("\xFF\xFE") || beginning.starts_with("\xFE\xFF");
    if (mayBeText && opened.size() <= kLargestTable)
      return kindOfText(opened.read(0, static_cast<std::size_t>(kLargestTable)));
    return FileKind::Surface;
  } catch (const InputError&) {
    return FileKind::Scene;
  }
}

}  // namespace asperity
