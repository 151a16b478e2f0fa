#include "core/measured/height_table.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/base/intervals.h"
#include "core/base/text.h"
#include "core/base/text_clause.h"
#include "core/base/text_header.h"
#include "core/base/text_number.h"
#include "core/base/text_units.h"
#include "core/measured/text_columns.h"
#include "core/measured/text_lengths.h"

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
  constexpr std::size_t kMaxWords = 3;  // more are a sentence
  if (parts.size() > kMaxWords) return Kind::Unknown;
  return hasOneOf(parts, kOthers)    ? Kind::Others
         : hasOneOf(parts, kHeights) ? Kind::Heights
                                     : Kind::Unknown;
}

/// Returns the text of a line that may name the table below it: "Height", "Height;um", "Channel:
/// Height"; empty where it states something else.
std::string_view tableName(const TextEntry& entry) {
  constexpr WordList kKeys("channel kanal image bild data daten type typ name quantity");
  if (entry.key.empty() || isOneOf(lowerCase(entry.key), kKeys)) return entry.value;
  // "Z unit: um" and "z: um" state a unit of the file.
  const bool hasUnit =
      entry.key.size() > 1 && entry.key.find(' ') == std::string::npos && metresPer(entry.value);
  return hasUnit ? std::string_view(entry.key) : std::string_view();
}

/// Returns the kind of a table by the nearest line above it that names one.
Kind kindOf(const TextBlock& block) {
  Kind kind = Kind::Unknown;
  for (const TextEntry& entry : block.header)
    if (const Kind found = kindOf(tableName(entry)); found != Kind::Unknown) kind = found;
  return kind;
}

/// Returns whether a name is that of a quantity that is no length: "Intensity", "Phase image
/// (deg)".
bool isOtherQuantity(std::string_view name, bool ofTable) {
  constexpr WordList kQuantities(
      "intensity intensit\u00E4t intensit\u00E9 intensidad intensit\u00E0 brightness helligkeit "
      "luminance reflectivity reflectance");
  // A profile has amplitudes as well, and a column of phases its unit.
  constexpr WordList kOfScans("amplitude phase deflection");
  constexpr std::size_t kMaxWords = 2;  // more are a sentence
  const TextColumn column = parseColumnName(withoutBrackets(trimmedField(name)));
  if (metresPer(column.unit)) return false;
  const auto words = wordsIn(column.name);
  // "Intensity 50 %" states a number.
  return words.size() <= kMaxWords && std::ranges::none_of(column.name, isDigit) &&
         (hasOneOf(words, kQuantities) || (ofTable && hasOneOf(words, kOfScans)));
}

/// Returns whether the numbers of some columns, but not of all, hardly change within each part, as
/// positions do along the lines of points of one grid.
bool areLinesOfPoints(const TextBlock& block, std::size_t rowsOfPart) {
  constexpr std::size_t kMin = 3, kMax = 12;  // columns of points
  constexpr double kSmallShare = 0.25;        // of the whole range
  if (block.columns.size() < kMin || block.columns.size() > kMax) return false;
  std::size_t steady = 0;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    Extent all;
    double widest = 0;
    for (std::size_t begin = 0; begin < block.rows; begin += rowsOfPart) {
      Extent part;
      for (std::size_t row = begin; row < begin + rowsOfPart; ++row) part.add(block.at(row, i));
      if (!part.isEmpty()) widest = std::max(widest, part.size());
      all.add(part.least);
      all.add(part.most);
    }
    steady += all.size() > 0 && widest < kSmallShare * all.size() ? 1 : 0;
  }
  return steady > 0 && steady < block.columns.size();
}

/// The course of the numbers of a column from row to row.
enum class RowCourse { AllAlong, PartByPart, Other };

/// Returns whether a column rises, or falls, from the first row to the last one, or within each
/// part and goes back between them.
RowCourse courseOf(const TextBlock& block, std::size_t column,
                   const std::vector<std::size_t>& begins) {
  for (const bool rises : {true, false}) {
    bool isAllAlong = true, isPartByPart = true;
    auto begin = begins.begin();
    for (std::size_t row = 0; row < block.rows; ++row) {
      const bool isFirst = begin != begins.end() && row == *begin;
      if (isFirst) ++begin;
      if (row == 0) continue;
      const double step = block.at(row, column) - block.at(row - 1, column);
      const bool goesOn = !std::isnan(step) && (rises ? step > 0 : step < 0);
      isAllAlong = isAllAlong && goesOn;
      isPartByPart = isPartByPart && goesOn != isFirst;
    }
    if (isAllAlong) return RowCourse::AllAlong;
    if (isPartByPart) return RowCourse::PartByPart;
  }
  return RowCourse::Other;
}

/// Returns after how many rows the positions of a profile in two columns begin anew and are the
/// same again, up to the last row; 0: they do not.
std::size_t rowsOfProfile(const TextBlock& block) {
  if (block.columns.size() != 2) return 0;
  for (const std::size_t column : {0, 1}) {
    std::size_t rows = 1;
    while (rows < block.rows && block.at(rows, column) != block.at(0, column)) ++rows;
    bool isAgain = rows < block.rows && block.rows % rows == 0;
    for (std::size_t row = rows; isAgain && row < block.rows; ++row)
      isAgain = block.at(row, column) == block.at(row - rows, column);
    if (isAgain) return rows;
  }
  return 0;
}

/// Returns where profiles begin that a column numbers, each with equally many rows and the same
/// positions in another column; empty where there are none.
std::vector<std::size_t> beginsOfNumbered(const TextBlock& block) {
  for (std::size_t column = 0; column < block.columns.size(); ++column) {
    if (!numbersProfiles(block, column)) continue;
    std::vector<std::size_t> begins{0};
    for (std::size_t row = 1; row < block.rows; ++row)
      if (block.at(row, column) != block.at(row - 1, column)) begins.push_back(row);
    const std::size_t rows = begins.size() > 1 ? begins[1] : block.rows;
    const bool areEqual = block.rows == rows * begins.size() && begins.back() == block.rows - rows;
    for (std::size_t x = 0; areEqual && rows < block.rows && x < block.columns.size(); ++x) {
      bool isAgain = isPositionName(lowerCase(block.columns[x].name));
      for (std::size_t row = rows; isAgain && row < block.rows; ++row)
        isAgain = block.at(row, x) == block.at(row - rows, x);
      if (isAgain) return begins;
    }
  }
  return {};
}

/// Returns where parts of a table begin that blank lines separate, or positions that begin anew.
std::vector<std::size_t> beginsOfParts(const TextBlock& block) {
  std::vector<std::size_t> begins{0};
  for (const auto& [row, count] : block.blanks) begins.push_back(row);
  if (const std::size_t rows = block.blanks.empty() ? rowsOfProfile(block) : 0; rows > 0)
    for (std::size_t row = rows; row < block.rows; row += rows) begins.push_back(row);
  return begins;
}

/// Returns whether blank lines separate tables, and no parts of one: those of profiles, whose
/// positions begin anew, or of equally many rows.
bool areTables(const TextBlock& block, const std::vector<std::size_t>& begins, bool areEqual) {
  bool beginAnew = false;
  for (std::size_t i = 0; i < block.columns.size(); ++i) {
    const RowCourse course = courseOf(block, i, begins);
    if (course == RowCourse::AllAlong) return false;
    beginAnew = beginAnew || course == RowCourse::PartByPart;
  }
  if (block.columns.size() == 2) return beginAnew;
  return areEqual && !areLinesOfPoints(block, begins[1]);
}

/// Returns whether two tables have the same columns with numbers alone, all with names.
bool haveSameColumns(const TextBlock& one, const TextBlock& other) {
  const auto hasNumbersAlone = [](const TextBlock& block) {
    return std::ranges::all_of(block.texts, &std::vector<std::string>::empty) &&
           std::ranges::all_of(block.cells, &std::vector<TextCell>::empty);
  };
  return hasNumbersAlone(one) && hasNumbersAlone(other) &&
         std::ranges::equal(one.columns, other.columns,
                            [](const TextColumn& a, const TextColumn& b) {
                              return !a.name.empty() && a.name == b.name && a.unit == b.unit;
                            });
}

/// Returns whether the positions of a table go on from the last one of the table before.
bool goesOn(const TextBlock& before, const TextBlock& next) {
  constexpr std::size_t kMinRows = 3;
  constexpr double kEqual = 0.05, kNear = 0.5;  // of a step
  if (before.rows < kMinRows || next.rows < kMinRows || !haveSameColumns(before, next))
    return false;
  const auto x = std::ranges::find_if(before.columns, [](const TextColumn& column) {
    return isPositionName(lowerCase(column.name));
  });
  if (x == before.columns.end()) return false;
  const auto column = static_cast<std::size_t>(x - before.columns.begin());
  const auto step = [column](const TextBlock& block) {
    return (block.at(block.rows - 1, column) - block.at(0, column)) /
           static_cast<double>(block.rows - 1);
  };
  const double usual = step(before);
  const double between = next.at(0, column) - before.at(before.rows - 1, column);
  return std::isless(std::abs(step(next) - usual), kEqual * std::abs(usual)) &&
         std::isless(std::abs(between - usual), kNear * std::abs(usual));
}

}  // namespace

std::size_t joinContinued(TextTable& table) {
  std::vector<TextBlock> joined;
  std::vector<std::size_t> counts;
  for (TextBlock& block : table.blocks) {
    if (joined.empty() || !goesOn(joined.back(), block)) {
      joined.push_back(std::move(block));
      counts.push_back(1);
      continue;
    }
    TextBlock& whole = joined.back();
    whole.rows += block.rows;
    whole.values.insert(whole.values.end(), block.values.begin(), block.values.end());
    whole.lines.insert(whole.lines.end(), block.lines.begin(), block.lines.end());
    ++counts.back();
  }
  table.blocks = std::move(joined);
  return counts[static_cast<std::size_t>(&table.largest() - table.blocks.data())];
}

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

std::size_t splitIntoParts(TextTable& table, std::size_t index, const SurfaceSource& source) {
  constexpr std::size_t kMinRows = 3;
  const TextBlock& whole = table.blocks[index];
  const std::vector<std::size_t> numbered = beginsOfNumbered(whole);
  std::vector<std::size_t> begins = numbered.empty() ? beginsOfParts(whole) : numbered;
  if (begins.size() == 1 || whole.columns.size() < 2) return 1;
  begins.push_back(whole.rows);  // the end of the last part
  const std::size_t parts = begins.size() - 1, rows = begins[1];
  bool areEqual = true;
  for (std::size_t i = 0; i < parts; ++i) {
    areEqual = areEqual && begins[i + 1] - begins[i] == rows;
    if (begins[i + 1] - begins[i] < kMinRows) return 1;
  }
  if (numbered.empty() && !areTables(whole, begins, areEqual)) return 1;
  const auto stated = statedCount({table, whole}, Counted::Rows);
  if (source.choices.format == "matrix" || stated == static_cast<std::int64_t>(whole.rows))
    return 1;
  std::vector<TextBlock> split;
  for (std::size_t i = 0; i < parts; ++i) {
    TextBlock& part = split.emplace_back();
    part.columns = whole.columns;
    part.rows = begins[i + 1] - begins[i];
    if (i > 0 && numbered.empty() && !whole.blanks.empty())
      part.blanks = {{0, whole.blanks[i - 1].second}};
    const auto first = static_cast<std::ptrdiff_t>(begins[i]),
               last = static_cast<std::ptrdiff_t>(begins[i + 1]),
               width = static_cast<std::ptrdiff_t>(whole.columns.size());
    part.values.assign(whole.values.begin() + first * width, whole.values.begin() + last * width);
    part.lines.assign(whole.lines.begin() + first, whole.lines.begin() + last);
    part.texts.resize(whole.columns.size());
    part.cells.resize(whole.columns.size());
  }
  split.front().header = whole.header;
  const auto place = table.blocks.erase(table.blocks.begin() + static_cast<std::ptrdiff_t>(index));
  table.blocks.insert(place, std::make_move_iterator(split.begin()),
                      std::make_move_iterator(split.end()));
  return parts;
}

std::size_t countHeadedProfiles(const TextTable& table, std::size_t index) {
  const auto& blocks = table.blocks;
  const std::vector<TextEntry>& first = blocks[index].header;
  const auto isNext = [&first](const std::vector<TextEntry>& header) {
    if (header.empty() || header.size() > first.size()) return false;
    auto above = first.end() - std::ssize(header);
    bool isHeaded = false;
    for (const TextEntry& entry : header) {
      const bool isHeading = isNextProfile(above->written, entry.written);
      if (!isHeading && entry.written != above->written) return false;
      isHeaded = isHeaded || isHeading;
      ++above;
    }
    return isHeaded;
  };
  std::size_t end = index + 1;
  while (end < blocks.size() && isNext(blocks[end].header)) ++end;
  return end - index;
}

void requireHeightName(const TextBlock& block, int column, const SurfaceSource& source,
                       std::vector<Message>& notes) {
  std::string name;
  if (column >= 0) {
    const TextColumn& one = columnAt(block, column);
    if (!metresPer(one.unit) && isOtherQuantity(one.name, false)) name = one.name;
  } else {
    for (const TextEntry& entry : block.header)
      if (isOtherQuantity(tableName(entry), true)) name = parseColumnName(tableName(entry)).name;
  }
  if (name.empty()) return;
  if (source.choices.heightUnit == "auto" && source.choices.heightColumn == 0)
    throw InputError(source.name, "surface.height_unit",
                     message("is needed ({}): the numbers are named '{}', which are no heights",
                             kUnitsOfKeys, shortened(name)));
  notes.push_back(
      message("The numbers are named '{}', which are no heights: they are taken as such all the "
              "same.",
              shortened(name)));
}

}  // namespace asperity
