#include "core/measured/height_table.h"

#include <algorithm>
#include <string>

#include "core/base/text.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"

namespace asperity {
namespace {

enum class Kind { Heights, Unknown, Others };

/// Returns the kind of a table with this name.
Kind kindOf(std::string_view name) {
  constexpr WordList kHeights(
      "z height heights h\u00F6he h\u00F6hen hoehe topography topographie topografie topo "
      "elevation "
      "hauteur hauteurs altezza altura \u9AD8\u3055");
  constexpr WordList kOthers(
      "intensity intensit\u00E4t light licht laser optical optisch brightness helligkeit color "
      "colour farbe gray grey rgb red green blue contrast quality mask error phase "
      "\u8F1D\u5EA6");
  std::string words = lowerCase(parseColumnName(withoutBrackets(trimmedField(name))).name);
  std::ranges::replace(words, '_', ' ');
  const auto parts = splitText(words, " ");
  constexpr std::size_t kMostWords = 3;  // more are a sentence
  if (parts.size() > kMostWords) return Kind::Unknown;
  return hasOneOf(parts, kOthers)    ? Kind::Others
         : hasOneOf(parts, kHeights) ? Kind::Heights
                                     : Kind::Unknown;
}

/// Returns the kind of a table by the nearest line above it that names one: "Height", "Height;um",
/// "Channel: Height".
Kind kindOf(const TextBlock& block) {
  constexpr WordList kKeys("channel kanal image bild data daten type typ name quantity");
  Kind kind = Kind::Unknown;
  for (const TextEntry& entry : block.header) {
    const bool isNamed = entry.key.empty() || isOneOf(lowerCase(entry.key), kKeys);
    // "Z unit: um" and "z: um" state a unit of the file.
    const bool hasUnit =
        entry.key.size() > 1 && entry.key.find(' ') == std::string::npos && metresPer(entry.value);
    if (!isNamed && !hasUnit) continue;
    const Kind found = kindOf(isNamed ? entry.value : entry.key);
    if (found != Kind::Unknown) kind = found;
  }
  return kind;
}

}  // namespace

HeightTable chooseHeightTable(const TextTable& table) {
  const auto& blocks = table.blocks;
  const TextBlock* chosen = &table.largest();
  const std::size_t most = chosen->values.size();
  if (blocks.size() == 1) return {};
  const Kind kind = kindOf(*chosen);
  // An intensity may have been measured at more points than the heights.
  constexpr std::size_t kFiner = 4;
  const std::size_t fewest = kind == Kind::Others ? most / kFiner : most;
  for (const Kind better : {Kind::Heights, Kind::Unknown}) {
    if (kindOf(*chosen) <= better) break;
    const std::size_t least = better == Kind::Heights ? fewest : most;
    const TextBlock* best = nullptr;
    for (const TextBlock& block : blocks)
      if (block.values.size() >= least && kindOf(block) == better &&
          (best == nullptr || block.values.size() > best->values.size()))
        best = &block;
    if (best != nullptr) chosen = best;
  }
  const auto equal = std::ranges::count_if(blocks, [chosen](const TextBlock& block) {
    return block.values.size() == chosen->values.size();
  });
  const std::uint32_t line = chosen->lines.front();
  return {static_cast<std::size_t>(chosen - blocks.data()),
          kindOf(*chosen) == Kind::Heights
              ? message("The file has {} tables of numbers; that of heights, from line {} on, is "
                        "read.",
                        blocks.size(), line)
          : equal > 1
              ? message("The file has {} tables of numbers; the first of {} equally large ones, "
                        "from line {} on, is read.",
                        blocks.size(), equal, line)
              : message("The file has {} tables of numbers; the largest one, from line {} on, is "
                        "read.",
                        blocks.size(), line)};
}

}  // namespace asperity
